// SPDX-License-Identifier: BSD-3-Clause
#include "TraceLedger.h"

namespace toss {

void TraceLedger::add(const RunSpan& runs) {
  for (const VoxelRun& run : runs) {
    VoxelSum& sum = sums_[run.key];
    sum.key = run.key;
    sum.count += static_cast<std::uint32_t>(run.count());
    sum.x += run.x();
    sum.y += run.y();
    sum.z += run.z();
    sum.intensity += run.intensity();
  }
}

void TraceLedger::subtractFrom(VoxelMap& map) const {
  for (const auto& [key, sum] : sums_) map.subtract(sum);
}

}  // namespace toss
