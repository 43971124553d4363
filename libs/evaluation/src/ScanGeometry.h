// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/LabelledCloud.h>
#include <toss/geometry/PosedScan.h>

#include <Eigen/Core>
#include <vector>

namespace toss {

/// Origin of the evaluation [m, map frame]: the point near `sensor` that is a whole number of 1000
/// voxels from the map's origin, so that the voxels of map and evaluation coincide.
Eigen::Vector3d evaluationOrigin(const Eigen::Vector3d& sensor, double voxelSize);

/// A scan in the frame of the evaluation, index-aligned with its points.
struct ScanGeometry {
  /// Coordinates, NaN for returns that are not valid; labels 0.
  LabelledCloud cloud;
  /// Distance from the sensor and horizontal distance [m], 0 for returns that are not valid.
  std::vector<float> range, horizontalRange;
};

/// Not valid: not finite, or at the sensor's origin.
void transformScan(const PosedScan& scan, const Eigen::Vector3d& origin, ScanGeometry& result);

}  // namespace toss
