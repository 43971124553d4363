// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VoxelRecord.h"

namespace toss {

/// The sums of voxels with more returns than a VoxelRecord counts: near a sensor that stands.
class LargeSums {
 public:
  /// Keeps sums, and names their place until erase().
  std::size_t insert(const VoxelSum& sum);
  VoxelSum& operator[](std::size_t place) { return sums_[place]; }
  const VoxelSum& operator[](std::size_t place) const { return sums_[place]; }
  void erase(std::size_t place) { free_.push_back(place); }
  std::size_t bytes() const {
    return sums_.capacity() * sizeof(VoxelSum) + free_.capacity() * sizeof(std::size_t);
  }

 private:
  std::vector<VoxelSum> sums_;
  /// Places that are not in use.
  std::vector<std::size_t> free_;
};

}  // namespace toss
