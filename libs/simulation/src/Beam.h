// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/SensorModel.h>

#include <Eigen/Core>
#include <cstdint>

#include "RayCaster.h"

namespace toss::simulation {

/// How a sensor errs.
struct BeamErrors {
  /// Standard deviation of ranges and the step in which they are reported [m].
  double rangeDeviation = 0.02, rangeStep = 0.002;
  /// Returns that get lost though they are strong enough, as a share.
  double loss = 0.01;
};

/// By the data sheets: Velodyne 2 cm in steps of 2 mm, Ouster 1.5 cm in steps of 1 mm.
BeamErrors errorsOf(const SensorModel& sensor);

/// One measurement of one beam; range 0 = nothing came back.
struct BeamReturn {
  double range = 0.0;
  float intensity = 0.0f;
  std::uint16_t label = 0, instance = 0;
};

/// What one beam of a sensor meets in the world and what the sensor makes of it: transparent
/// materials let beams pass by chance, beams as wide as they are straddle edges (a return then lies
/// between both surfaces), glossy patches mirror them (the sensor then reports the length of the
/// detour straight ahead: under the road), weak returns are lost.
class Beam {
 public:
  /// `noise` off: every beam gives the exact range of the first surface.
  Beam(const RayCaster& caster, const SensorModel& sensor, bool noise);

  /// `direction`: unit vector in the map frame; `key`: random key of this beam in this scan.
  BeamReturn measure(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double share,
                     std::uint64_t key) const;

 private:
  RayHit firstOpaque(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double share,
                     std::uint64_t key) const;
  double straddled(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double share,
                   double range, std::uint64_t key) const;
  double mirroredDetour(const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                        const RayHit& hit, double share) const;
  bool isLost(double reflected, double range, std::uint64_t key) const;
  double reported(double range, std::uint64_t key) const;

  const RayCaster& caster_;
  const SensorModel& sensor_;
  BeamErrors errors_;
  bool noise_;
};

}  // namespace toss::simulation
