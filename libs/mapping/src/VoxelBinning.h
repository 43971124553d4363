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
  struct Return {
    /// Voxel index counted from the first voxel, and offset inside it [1/65536 voxel].
    std::uint32_t voxel[3];
    std::uint16_t offset[3];
    /// [1/65536 unit].
    std::uint32_t intensity;
  };
  /// Least and greatest voxel index of the returns along one axis.
  struct Range {
    std::uint32_t least, greatest;
    int bits() const;
  };
  Range range(int axis) const;
  /// Fills order_ with the places of the returns by key, those of one key in order of their coming.
  void sortByVoxel();
  void sortByComparison();

  std::vector<Return> returns_;
  std::vector<std::uint64_t> items_, buffer_;
  std::vector<std::uint32_t> order_;
};

}  // namespace toss
