// SPDX-License-Identifier: BSD-3-Clause
#include "World.h"

#include <cmath>
#include <utility>

namespace toss::simulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

bool differs(const Isometry3d& a, const Isometry3d& b) {
  constexpr double kSmallest = 1e-3;
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() > kSmallest;
}

}  // namespace

Box boxOf(const Figure& figure, const Isometry3d& pose) {
  Box box;
  box.center = pose * Vector3d(0.0, 0.0, 0.5 * figure.size.z());
  const double yaw = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
  box.yaw = yaw - M_PI * std::floor(yaw / M_PI + 0.5);
  box.length = figure.size.x(), box.width = figure.size.y(), box.height = figure.size.z();
  return box;
}

void World::add(const Mesh& mesh, const Isometry3d& pose) {
  still.append(mesh, pose);
  stillInstances.resize(still.triangles.size(), 0);
}

void World::place(const Mesh& mesh, double x, double y, double yaw) {
  add(mesh, planarPose(x, y, groundHeight(x, y), yaw));
}

void World::park(const Figure& figure, double x, double y, double yaw) {
  const Isometry3d pose = planarPose(x, y, groundHeight(x, y), yaw);
  const std::uint16_t instance = nextInstance_++;
  for (std::size_t part = 0; part < figure.parts.size(); ++part) {
    Mesh mesh = figure.parts[part];
    for (Surface& surface : mesh.surfaces) surface.label = figure.stillLabel;
    still.append(mesh, pose * figure.partPose(part, 0.0, 0.0));
  }
  stillInstances.resize(still.triangles.size(), instance);
  stillObjects.push_back({instance, figure.stillLabel, boxOf(figure, pose)});
}

void World::addMover(Figure figure, Motion motion) {
  movers.push_back({std::move(figure), std::move(motion), nextInstance_++});
}

Isometry3d World::poseOf(const Mover& mover, double time) const {
  const Vector2d position = mover.motion.position(time);
  return planarPose(position.x(), position.y(), groundHeight(position.x(), position.y()),
                    mover.motion.heading(time));
}

Isometry3d World::mapFromSensor(double time) const {
  const double distance = carrier.motion.distance(time);
  const Vector2d position = carrier.motion.path.position(distance);
  const auto height = [&](double ahead) {
    const Vector2d p = carrier.motion.path.position(distance + ahead);
    return groundHeight(p.x(), p.y());
  };
  constexpr double kHalfBase = 0.4;
  const double slope = std::atan2(height(kHalfBase) - height(-kHalfBase), 2.0 * kHalfBase);
  const double phase = 2.0 * M_PI * distance / (2.0 * carrier.step);
  const double ground = (height(-kHalfBase) + height(0.0) + height(kHalfBase)) / 3.0;

  Isometry3d pose =
      planarPose(position.x(), position.y(),
                 ground + carrier.sensorHeight + carrier.bounce * std::sin(2.0 * phase),
                 carrier.motion.path.heading(distance));
  pose.rotate(AngleAxisd(-slope + carrier.pitch * std::sin(2.0 * phase + 1.0), Vector3d::UnitY()));
  pose.rotate(AngleAxisd(carrier.roll * std::sin(phase), Vector3d::UnitX()));
  if (carrier.mount.matrix() == Eigen::Matrix4d::Identity()) return pose;
  return pose * carrier.mount;
}

bool World::movesWithin(const Mover& mover, double start, double step, int count) const {
  for (std::size_t part = 0; part < mover.figure.parts.size(); ++part) {
    const auto partPose = [&](double time) {
      return poseOf(mover, time) * mover.figure.partPose(part, mover.motion.distance(time), time);
    };
    const Isometry3d first = partPose(start);
    for (int i = 1; i < count; ++i) {
      if (differs(first, partPose(start + i * step))) return true;
    }
  }
  return false;
}

}  // namespace toss::simulation
