// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// Groups returns by voxel: fixed-point coordinates, one integer sort, one pass of sums. Keeps its
/// buffers from call to call; one per thread.
class VoxelBinning {
 public:
  /// Fixed-point coordinate along one axis: level coordinate [m] * scale + shift, in 1/65536 of a
  /// voxel, counted from the first voxel that keys can hold.
  struct Axis {
    const float* level;
    double shift;
  };

  /// Takes the returns in; returns how many were left out. `scale`: 65536 / voxel size [1/m].
  std::size_t take(const Axis& x, const Axis& y, const Axis& z, double scale,
                   const std::vector<float>& intensity, IndexSpan indices);
  /// Sums what was taken in by voxel, at most `cap` returns each, the first first.
  void sum(std::uint32_t cap, std::vector<VoxelContribution>& result);

 private:
  /// Offset inside the voxel [1/65536 voxel] and intensity [1/65536 unit].
  struct Return {
    std::uint32_t intensity;
    std::uint16_t x, y, z;
  };
  /// Fills items_ by ascending key: the place of each return in the lower bits, of which it returns
  /// the number, and above them what only returns of one voxel share; those of one voxel in order
  /// of their coming.
  int sortByVoxel();
  void sortByComparison(int placeBits);

  /// Of the returns in order of their coming.
  std::vector<VoxelKey> keys_;
  std::vector<Return> returns_;
  std::vector<std::uint64_t> items_, buffer_;
};

}  // namespace toss
