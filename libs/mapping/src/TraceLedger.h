// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <tsl/robin_map.h>

namespace toss {

/// What the folded boxes of one trace have put into the map: one sum per voxel, however often the
/// trace was seen there (spec section 8.3).
class TraceLedger {
 public:
  void add(const RunSpan& runs);
  void subtractFrom(VoxelMap& map) const;
  std::size_t bytes() const { return sums_.bucket_count() * sizeof(*sums_.begin()); }

 private:
  tsl::robin_map<VoxelKey, VoxelSum> sums_;
};

}  // namespace toss
