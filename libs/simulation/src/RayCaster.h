// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "Surface.h"

namespace toss {
namespace simulation {

struct World;

/// What a ray meets first.
struct RayHit {
  /// Distance along the ray [m], negative where it meets nothing.
  double range = -1.0;
  /// Unit normal of the surface, turned against the ray, map frame.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Surface surface{};
  /// Index of the mover or -1, and instance id (0 = none).
  int mover = -1;
  std::uint16_t instance = 0;
};

/// Finds the nearest triangle with Embree; range and normal are then computed in double precision
/// from the triangle itself, with the mover's pose at the time of the ray. So Embree decides only
/// which triangle is met; it is held to one instruction set, for the same answer on every x86-64.
class RayCaster {
 public:
  /// The world must outlive the ray caster.
  explicit RayCaster(const World& world);
  ~RayCaster();

  /// Sets the span of time of the rays to come: movers travel in kSteps straight steps within it.
  void setSweep(double begin, double end);
  static constexpr int kSteps = 5;

  /// `direction`: unit vector, map frame. `share` of the sweep's span at which the ray is cast, 0
  /// to 1. Only triangles farther than `nearest` count. Safe to call from several threads.
  RayHit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double share,
              double nearest, double farthest) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simulation
}  // namespace toss
