// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// Returns of one call as the voxels see them: lends the caller's buffers.
struct VoxelReturns {
  /// Fixed-point coordinate along one axis: level coordinate [m] * scale + shift, in 1/65536 of a
  /// voxel, counted from the first voxel that keys can hold.
  struct Axis {
    const float* level;
    double shift;
  };
  Axis x, y, z;
  /// 65536 / voxel size [1/m].
  double scale;
  /// Shape of the scan, or nullptr: then all count as 0.
  const float* intensity;
  /// Where the returns stand in the scan, or nullptr: one after another.
  const std::int32_t* indices;
  /// Number of returns: places are 0 .. count - 1.
  std::size_t count;
  /// Owner of each place, or nullptr: all have owner 0. Those below 0 are passed over.
  const std::int32_t* owner = nullptr;
};

}  // namespace toss
