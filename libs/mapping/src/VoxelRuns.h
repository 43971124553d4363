// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// Neighbouring returns of a scan that lie in one voxel and have one owner, summed up.
struct VoxelRun {
  VoxelRun() = default;
  VoxelRun(VoxelKey key, std::uint32_t ownerOfAll) : owner(ownerOfAll) { sum.key = key; }

  /// Members as in VoxelContribution.
  VoxelContribution sum;
  std::uint32_t owner = 0;
  /// Places: of the first of them, and behind the last that counts.
  std::uint32_t begin = 0, end = 0;
};

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

/// Appends the runs of the returns at places [begin, end), each at most `cap` returns long; what is
/// beyond `cap` in a row is dropped. Returns how many were left out because they are not finite or
/// out of reach.
std::size_t appendRuns(const VoxelReturns& returns, std::size_t begin, std::size_t end,
                       std::uint32_t cap, std::vector<VoxelRun>& runs);

}  // namespace toss
