// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/LabelledCloud.h>
#include <toss/mapping/VoxelMap.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace toss {

/// Preservation and rejection rate in voxels (ERASOR; spec section 9.3). Rates are in percent and
/// NaN where the truth has no such voxel.
struct PreservationRejection {
  /// Voxels of the truth that are static, and of them those that the estimate still has as static.
  std::uint64_t staticVoxels = 0, staticKept = 0;
  /// Voxels of the truth that are moving, and of them those that the estimate still has as moving.
  std::uint64_t movingVoxels = 0, movingLeft = 0;

  /// PR = 100 staticKept / staticVoxels.
  double preservationRate() const;
  /// RR = 100 (1 - movingLeft / movingVoxels).
  double rejectionRate() const;
  /// F1 = 2 PR RR / (PR + RR), from 0 to 1.
  double f1() const;
};

/// What has become of a voxel of the truth.
enum class VoxelFate : std::uint8_t {
  Kept,     ///< static, and still there
  Lost,     ///< static, and gone or taken for moving
  Removed,  ///< moving, and gone
  Residue   ///< moving, and still there
};

/// Truth and estimate held against each other, voxel by voxel.
struct MapComparison {
  PreservationRejection score;
  /// Shape [truth].
  std::vector<VoxelFate> fate;
  /// Nearest point of the estimate nearer than voxelSize sqrt(3) / 2, -1 = none, shape [truth].
  std::vector<std::int32_t> nearest;
};

/// Compares two maps that were voxelised at `voxelSize` [m]. A voxel of the truth is an inlier
/// where the nearest point of the estimate is strictly nearer than voxelSize sqrt(3) / 2. It counts
/// as kept (static) or left (moving) where it is an inlier and that point's label is of the same
/// kind.
MapComparison compareMaps(const LabelledCloud& truth, const LabelledCloud& estimate,
                          double voxelSize);

/// The voxels of the truth by fate, for pictures. Map frame [m], intensity 0.
struct MapErrors {
  std::vector<MapPoint> kept, removed, residue, lost;
};

/// `origin`: map coordinates [m] of the origin of the clouds.
MapErrors mapErrors(const LabelledCloud& truth, const MapComparison& comparison,
                    const Eigen::Vector3d& origin);

}  // namespace toss
