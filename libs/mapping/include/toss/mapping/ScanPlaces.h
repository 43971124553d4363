// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelKey.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Core>
#include <cstdint>

namespace toss {

/// Voxels of a map in which the returns of one scan lie. Refers to the coordinates of the caller.
struct ScanPlaces {
  /// Level frame [m].
  const LevelPoints& level;
  /// Fixed-point coordinate: level coordinate [m] * scale + shift, in 1/65536 of a voxel, counted
  /// from the first voxel that keys can hold. Scale 0: there are no voxels, all have key 0.
  double scale = 0.0;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  /// Of return `i`, which is within reach of the map.
  VoxelKey of(std::size_t i) const {
    const auto index = [this](float coordinate, double shiftOfAxis) {
      // Not below 0, where rounding towards it would not be rounding down.
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(
                 static_cast<double>(coordinate) * scale + shiftOfAxis)) >>
             16;
    };
    return voxelKeyFromFirst(index(level.x[i], shift.x()), index(level.y[i], shift.y()),
                             index(level.z[i], shift.z()));
  }
};

}  // namespace toss
