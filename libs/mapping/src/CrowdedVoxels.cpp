// SPDX-License-Identifier: BSD-3-Clause
#include "CrowdedVoxels.h"

#include <algorithm>

namespace toss {

void CrowdedVoxels::clear(std::uint32_t cap) {
  cap_ = cap;
  any_ = false;
  std::fill(counts_.begin(), counts_.end(), 0u);
  taken_.clear();
  full_.clear();
}

void CrowdedVoxels::add(const VoxelRun& single) {
  Taken& taken = taken_[{single.key, single.owner()}];
  if (taken.count == cap_) return;
  if (taken.count++ % VoxelRun::kMostReturns == 0) {
    if (taken.count > 1) full_.push_back(taken.run);
    taken.run = single;
    return;
  }
  taken.run.countAndOffsets += single.countAndOffsets;
  taken.run.ownerAndIntensity += single.intensity();
}

}  // namespace toss
