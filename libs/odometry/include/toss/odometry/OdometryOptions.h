// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How poses are found from the scans alone. Section "odometry". Defaults and the meaning of all of
/// them: Vizzo et al., KISS-ICP, RA-L 2023.
struct OdometryOptions : Options {
  /// Returns nearer or farther than this from the sensor do not take part [m].
  double minRange = 1.0, maxRange = 100.0;
  /// Edge of the voxels of the local map [m]; the scan is thinned to half of it for the map and to
  /// 1.5 times of it for the alignment. 0 = maxRange / 100.
  double voxelSize = 0.0;
  /// Most points of the local map per voxel.
  int pointsPerVoxel = 20;
  /// How far from the prediction the pose is expected to lie at first [m]: sigma of the adaptive
  /// threshold before it has seen motion.
  double initialThreshold = 2.0;
  /// Greatest speed that the sensor may have at the first scan [m/s]; 0 = it stands.
  double startSpeed = 50.0;
  /// Deviations from the prediction below this do not count for the adaptive threshold [m].
  double minMotion = 0.1;
  /// Most iterations of the alignment, and the step [m, rad] below which it has converged.
  int maxIterations = 100;
  double convergence = 1e-4;

  const char* section() const override { return "odometry"; }
  void visit(OptionVisitor& visitor) override;

  /// voxelSize, or what stands for 0.
  double effectiveVoxelSize() const { return voxelSize > 0.0 ? voxelSize : maxRange / 100.0; }
};

}  // namespace toss
