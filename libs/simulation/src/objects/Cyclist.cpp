// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "People.h"

namespace toss::simulation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::uint16_t kLabel = semantics::kBicyclist;
constexpr Surface kCloth{kLabel, Material::Cloth};
constexpr Surface kFrame{kLabel, Material::Metal};

/// Hip of the rider over the saddle, and how far a foot goes around the bottom bracket [m].
const Vector3d kHip(-0.2, 0.0, 0.95), kBracket(0.0, 0.0, 0.3);
constexpr double kCrank = 0.17;

void addWheel(Mesh& mesh, double x) {
  constexpr double kRadius = 0.34;
  constexpr int kSides = 14;
  const auto rim = [&](int i) {
    const double angle = 2.0 * M_PI * i / kSides;
    return Vector3d(x + kRadius * std::cos(angle), 0.0, kRadius + kRadius * std::sin(angle));
  };
  for (int i = 0; i < kSides; ++i) {
    mesh.addBar(rim(i), rim(i + 1), 0.022, 0.022, {kLabel, Material::Rubber}, 4);
    mesh.addTriangle({x, 0.0, kRadius}, rim(i), rim(i + 1), {kLabel, Material::Wire});
  }
}

Mesh bicycle() {
  Mesh mesh;
  addWheel(mesh, 0.52);
  addWheel(mesh, -0.52);
  const Vector3d saddle(-0.22, 0.0, 0.92), head(0.38, 0.0, 0.85);
  for (const auto& [from, to] : {std::pair<Vector3d, Vector3d>{saddle, kBracket},
                                 {kBracket, head},
                                 {head, {-0.2, 0.0, 0.8}},
                                 {{-0.52, 0.0, 0.34}, kBracket},
                                 {{-0.52, 0.0, 0.34}, {-0.2, 0.0, 0.8}},
                                 {{0.52, 0.0, 0.34}, {0.34, 0.0, 1.02}}}) {
    mesh.addBar(from, to, 0.02, 0.02, kFrame, 5);
  }
  mesh.addBar({0.34, -0.28, 1.05}, {0.34, 0.28, 1.05}, 0.015, 0.015, kFrame, 5);
  return mesh;
}

/// Trunk, head and arms of the rider, bent forward.
void addRider(Mesh& mesh) {
  const Vector3d shoulder(0.12, 0.0, 1.42);
  mesh.addBar(kHip, shoulder, 0.15, 0.18, kCloth, 8);
  mesh.addEllipsoid({0.2, 0.0, 1.66}, {0.11, 0.09, 0.13}, {kLabel, Material::Skin});
  for (double side : {-1.0, 1.0}) {
    mesh.addBar(shoulder + Vector3d(0.0, side * 0.2, 0.0), {0.34, side * 0.26, 1.07}, 0.05, 0.035,
                kCloth, 6);
  }
}

/// One leg, straight from hip to pedal, in the frame of the hip, hanging along -z.
Mesh leg() {
  Mesh mesh;
  mesh.addBar(Vector3d::Zero(), {0.0, 0.0, -0.68}, 0.08, 0.045, kCloth, 6);
  mesh.addBox({0.05, 0.0, -0.7}, {0.25, 0.09, 0.07}, {kLabel, Material::Rubber});
  return mesh;
}

/// Turns the leg so that it points at its pedal.
Isometry3d legPose(double side, double distance) {
  constexpr double kPerTurn = 5.0;
  const double phase = 2.0 * M_PI * distance / kPerTurn + (side > 0.0 ? 0.0 : M_PI);
  const Vector3d pedal = kBracket + kCrank * Vector3d(std::cos(phase), 0.0, -std::sin(phase));
  const Vector3d down = pedal - kHip;
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(kHip + Vector3d(0.0, side * 0.11, down.norm() < 0.6 ? 0.1 : 0.0));
  pose.rotate(Eigen::AngleAxisd(std::atan2(-down.x(), -down.z()), Vector3d::UnitY()));
  return pose;
}

}  // namespace

Figure makeCyclist() {
  Figure figure;
  figure.parts = {bicycle(), leg(), leg()};
  addRider(figure.parts[0]);
  figure.articulation = [](std::size_t part, double distance, double) {
    return part == 0 ? Isometry3d::Identity() : legPose(part == 1 ? 1.0 : -1.0, distance);
  };
  figure.size = {1.75, 0.62, 1.79};
  figure.stillLabel = kLabel, figure.movingLabel = semantics::kMovingBicyclist;
  return figure;
}

}  // namespace toss::simulation
