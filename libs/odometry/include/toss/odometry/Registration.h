// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/odometry/LocalMap.h>

#include <Eigen/Geometry>
#include <vector>

namespace toss {

/// When the alignment of a scan to the local map ends, and which pairs count.
struct RegistrationLimits {
  /// Pairs farther apart than this do not count [m] (KISS-ICP: 3 sigma).
  double maxDistance = 3.0;
  /// Scale of the robust kernel [m] (KISS-ICP: sigma / 3).
  double kernelScale = 1.0 / 3.0;
  int maxIterations = 100;
  /// Steps smaller than this end it [m, rad].
  double convergence = 1e-4;
};

/// The result of an alignment.
struct Alignment {
  /// map <- sensor.
  Eigen::Isometry3d mapFromSensor = Eigen::Isometry3d::Identity();
  int iterations = 0;
  bool converged = false;
  /// Share of the points that have a pair, 0 to 1.
  double overlap = 0.0;
  /// How sharply the points lie on the map: mean over all of them of a kernel of 10 cm, 0 to 1.
  /// Unlike the robust kernel it does not change with the limits.
  double fit = 0.0;
  /// How well the geometry holds the position in the direction in which it holds it worst: share of
  /// all pairs' weight that pulls there, 0 (not at all) to 1/3 (in all directions alike).
  double weakestHold = 0.0;
};

/// How well points [m, sensor frame] fit the map at `pose` (map <- sensor): the mean of the robust
/// kernel over all of them, 0 to 1; what align() makes as large as it can.
double fitness(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
               const Eigen::Isometry3d& pose, const RegistrationLimits& limits);

/// Aligns points [m, sensor frame] to the map: ICP with the robust kernel of Geman and McClure,
/// beginning at `guess` (map <- sensor) (KISS-ICP, section III-E); from point to plane where the
/// map has a plane: from point to point alone the rings that beams draw on the ground hold the
/// sensor back. Runs on all threads that TBB may use; the result does not depend on their number.
Alignment align(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
                const Eigen::Isometry3d& guess, const RegistrationLimits& limits);

}  // namespace toss
