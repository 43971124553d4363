// SPDX-License-Identifier: BSD-3-Clause
#include "RayCaster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "World.h"

namespace toss::simulation {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr std::size_t kTimes = RayCaster::kSteps + 1;

/// A part of a mover with its poses at equal steps over the sweep.
struct MovingPart {
  const Mesh* mesh;
  int mover;
  std::size_t part;
  RTCGeometry instance;
  std::vector<Matrix4d> poses;

  /// Between two steps the matrix changes linearly, as it does in Embree.
  Affine3d poseAt(double share) const {
    const double position = std::clamp(share, 0.0, 1.0) * RayCaster::kSteps;
    const auto step = std::min(static_cast<std::size_t>(position), kTimes - 2);
    const double rest = position - static_cast<double>(step);
    Affine3d pose;
    pose.matrix() = (1.0 - rest) * poses[step] + rest * poses[step + 1];
    return pose;
  }
};

RTCScene makeScene(RTCDevice device, const Mesh& mesh) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  if (!mesh.triangles.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), mesh.vertices.size());
    std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(Eigen::Vector3f));
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), mesh.triangles.size());
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  return scene;
}

RTCRayHit rayHit(const Vector3d& origin, const Vector3d& direction, double share, double nearest,
                 double farthest) {
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x());
  query.ray.org_y = static_cast<float>(origin.y());
  query.ray.org_z = static_cast<float>(origin.z());
  query.ray.dir_x = static_cast<float>(direction.x());
  query.ray.dir_y = static_cast<float>(direction.y());
  query.ray.dir_z = static_cast<float>(direction.z());
  query.ray.time = static_cast<float>(std::clamp(share, 0.0, 1.0));
  query.ray.tnear = static_cast<float>(nearest);
  query.ray.tfar = static_cast<float>(farthest);
  query.ray.mask = 0xFFFFFFFFu;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

/// Sets range and normal of `hit` from the plane of triangle `index`.
void meet(const Mesh& mesh, std::uint32_t index, const Affine3d& pose, const Vector3d& origin,
          const Vector3d& direction, RayHit& hit) {
  const auto& corners = mesh.triangles[index];
  const Vector3d a = pose * mesh.vertices[corners[0]].cast<double>();
  const Vector3d b = pose * mesh.vertices[corners[1]].cast<double>();
  const Vector3d c = pose * mesh.vertices[corners[2]].cast<double>();
  const Vector3d normal = (b - a).cross(c - a).normalized();
  const double approach = normal.dot(direction);
  // Where a ray lies in the plane it meets an edge, which the plane does not tell: Embree's stands.
  const double exact = normal.dot(a - origin) / approach;
  if (std::abs(exact - hit.range) < 0.01 + 0.001 * hit.range) hit.range = exact;
  hit.normal = approach > 0.0 ? Vector3d(-normal) : normal;
  hit.surface = mesh.surfaces[index];
}

}  // namespace

struct RayCaster::Implementation {
  const World& world;
  RTCDevice device;
  RTCScene still, moving;
  std::vector<MovingPart> parts;
  std::vector<RTCScene> partScenes;

  explicit Implementation(const World& w) : world(w), device(rtcNewDevice("isa=sse2")) {
    if (!device) throw std::runtime_error("Embree can not be started on this processor");
    still = makeScene(device, world.still);
    moving = rtcNewScene(device);
    rtcSetSceneFlags(moving, RTC_SCENE_FLAG_ROBUST);
    for (std::size_t mover = 0; mover < world.movers.size(); ++mover) addParts(mover);
    rtcCommitScene(moving);
  }

  ~Implementation() {
    rtcReleaseScene(moving);
    for (RTCScene scene : partScenes) rtcReleaseScene(scene);
    rtcReleaseScene(still);
    rtcReleaseDevice(device);
  }

  void addParts(std::size_t mover) {
    const Figure& figure = world.movers[mover].figure;
    for (std::size_t part = 0; part < figure.parts.size(); ++part) {
      partScenes.push_back(makeScene(device, figure.parts[part]));
      RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, partScenes.back());
      rtcSetGeometryTimeStepCount(instance, kTimes);
      rtcCommitGeometry(instance);
      rtcAttachGeometryByID(moving, instance, static_cast<unsigned>(parts.size()));
      rtcReleaseGeometry(instance);  // the scene keeps it
      parts.push_back({&figure.parts[part], static_cast<int>(mover), part, instance,
                       std::vector<Matrix4d>(kTimes, Matrix4d::Identity())});
    }
  }

  void setSweep(double begin, double end) {
    for (MovingPart& part : parts) {
      const Mover& mover = world.movers[static_cast<std::size_t>(part.mover)];
      for (std::size_t step = 0; step < kTimes; ++step) {
        const double time = begin + (end - begin) * static_cast<double>(step) / kSteps;
        const Eigen::Isometry3d pose =
            world.poseOf(mover, time) *
            mover.figure.partPose(part.part, mover.motion.distance(time), time);
        part.poses[step] = pose.matrix();
        const Eigen::Matrix4f matrix = pose.matrix().cast<float>();
        rtcSetGeometryTransform(part.instance, static_cast<unsigned>(step),
                                RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, matrix.data());
      }
      rtcCommitGeometry(part.instance);
    }
    rtcCommitScene(moving);
  }

  RayHit cast(const Vector3d& origin, const Vector3d& direction, double share, double nearest,
              double farthest) const {
    RayHit hit;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = rayHit(origin, direction, share, nearest, farthest);
    rtcIntersect1(still, &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      hit.range = static_cast<double>(query.ray.tfar);
      hit.instance = world.stillInstances[query.hit.primID];
      meet(world.still, query.hit.primID, Affine3d::Identity(), origin, direction, hit);
    }
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcInitIntersectContext(&context);
    rtcIntersect1(moving, &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      const MovingPart& part = parts[query.hit.instID[0]];
      hit.range = static_cast<double>(query.ray.tfar);
      hit.mover = part.mover;
      hit.instance = world.movers[static_cast<std::size_t>(part.mover)].instance;
      meet(*part.mesh, query.hit.primID, part.poseAt(share), origin, direction, hit);
    }
    return hit;
  }
};

RayCaster::RayCaster(const World& world)
    : implementation_(std::make_unique<Implementation>(world)) {}
RayCaster::~RayCaster() = default;

void RayCaster::setSweep(double begin, double end) {
  implementation_->setSweep(begin, end);
}

RayHit RayCaster::cast(const Vector3d& origin, const Vector3d& direction, double share,
                       double nearest, double farthest) const {
  return implementation_->cast(origin, direction, share, nearest, farthest);
}

}  // namespace toss::simulation
