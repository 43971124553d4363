// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "People.h"

namespace toss::simulation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr Surface kCloth{semantics::kPerson, Material::Cloth};
constexpr Surface kSkin{semantics::kPerson, Material::Skin};

/// Parts in the order in which the figure holds them.
enum Part : std::size_t {
  kTrunk,
  kThighLeft,
  kThighRight,
  kShinLeft,
  kShinRight,
  kArmLeft,
  kArmRight
};

/// Lengths and places of the joints, as shares of the height.
struct Body {
  double height;
  double hip() const { return 0.52 * height; }
  double knee() const { return 0.28 * height; }
  double shoulder() const { return 0.81 * height; }
  double hipSide() const { return 0.055 * height; }
  double shoulderSide() const { return 0.135 * height; }
};

Mesh trunkOf(const Body& body) {
  const double h = body.height;
  Mesh mesh;
  mesh.addEllipsoid({0.0, 0.0, 0.57 * h}, {0.075 * h, 0.10 * h, 0.09 * h}, kCloth);
  mesh.addEllipsoid({0.0, 0.0, 0.70 * h}, {0.075 * h, 0.12 * h, 0.16 * h}, kCloth);
  mesh.addBar({0.0, 0.0, 0.82 * h}, {0.0, 0.0, 0.89 * h}, 0.03 * h, 0.03 * h, kSkin, 6);
  mesh.addEllipsoid({0.01, 0.0, 0.93 * h}, {0.055 * h, 0.045 * h, 0.07 * h}, kSkin);
  return mesh;
}

/// A limb that hangs from its joint at the origin.
Mesh limb(double length, double radiusTop, double radiusEnd, Surface surface) {
  Mesh mesh;
  mesh.addBar(Vector3d::Zero(), {0.0, 0.0, -length}, radiusTop, radiusEnd, surface, 6);
  return mesh;
}

Mesh shinOf(const Body& body) {
  Mesh mesh = limb(body.knee() - 0.02, 0.055, 0.04, kCloth);
  mesh.addBox({0.06, 0.0, 0.04 - body.knee()}, {0.26, 0.09, 0.08},
              {semantics::kPerson, Material::Rubber});
  return mesh;
}

Isometry3d hinge(const Vector3d& joint, double angle) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(joint).rotate(AngleAxisd(angle, Vector3d::UnitY()));
  return pose;
}

/// Angles of a step: the thigh swings, the knee bends while the leg comes forward.
Isometry3d pose(const Body& body, std::size_t part, double distance, double stride) {
  if (part == kTrunk) return Isometry3d::Identity();
  const double side = part % 2 == 1 ? 1.0 : -1.0;
  const double phase = 2.0 * M_PI * distance / stride + (side > 0.0 ? 0.0 : M_PI);
  const double swing = std::min(0.45, 0.32 * stride) * std::sin(phase);
  if (part >= kArmLeft) {
    return hinge({0.0, side * body.shoulderSide(), body.shoulder()}, 0.8 * swing);
  }
  const Isometry3d thigh = hinge({0.0, side * body.hipSide(), body.hip()}, -swing);
  if (part <= kThighRight) return thigh;
  const double bend = std::min(0.8, 0.55 * stride) * std::max(0.0, std::cos(phase));
  return thigh * hinge({0.0, 0.0, body.knee() - body.hip()}, bend);
}

}  // namespace

Figure makePedestrian(double height, double stride) {
  const Body body{height};
  const Mesh thigh = limb(body.hip() - body.knee(), 0.085, 0.06, kCloth);
  const Mesh arm = limb(0.38 * height, 0.05, 0.035, kCloth);
  Figure figure;
  figure.parts = {trunkOf(body), thigh, thigh, shinOf(body), shinOf(body), arm, arm};
  figure.articulation = [body, stride](std::size_t part, double distance, double) {
    return pose(body, part, distance, stride);
  };
  figure.size = {0.45, 0.34 * height, height};
  figure.stillLabel = semantics::kPerson, figure.movingLabel = semantics::kMovingPerson;
  return figure;
}

Figure makePedestrian(RandomStream& random) {
  const double height = random.uniform(1.5, 1.9);
  return makePedestrian(height, random.uniform(1.1, 1.5));
}

}  // namespace toss::simulation
