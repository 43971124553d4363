// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// What the folded boxes of one trace have put into the map: one sum per voxel, however often the
/// trace was seen there (spec section 8.3).
class TraceLedger {
 public:
  void add(const ContributionSpan& contributions);
  /// By ascending key.
  const std::vector<VoxelSum>& sums() const { return sums_; }
  std::size_t bytes() const { return sums_.capacity() * sizeof(VoxelSum); }

 private:
  std::vector<VoxelSum> sums_;
};

}  // namespace toss
