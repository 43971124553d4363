// SPDX-License-Identifier: BSD-3-Clause
#include "LargeSums.h"

namespace toss {

std::size_t LargeSums::insert(const VoxelSum& sum) {
  if (free_.empty()) {
    sums_.push_back(sum);
    return sums_.size() - 1;
  }
  const std::size_t place = free_.back();
  free_.pop_back();
  sums_[place] = sum;
  return place;
}

}  // namespace toss
