// SPDX-License-Identifier: BSD-3-Clause
#include "ScanLedger.h"

#include <numeric>

namespace toss {

void ScanLedger::swap(std::vector<VoxelRun>& runs) {
  runs_.swap(runs);
  counts_.clear();
  ends_.clear();
  for (const VoxelRun& run : runs_) {
    if (run.owner() >= counts_.size()) counts_.resize(run.owner() + 1, 0);
    ++counts_[run.owner()];
  }
}

RunSpan ScanLedger::of(std::size_t owner) {
  if (count(owner) == 0) return {};
  if (ends_.empty()) orderByOwner();
  const VoxelRun* const end = runs_.data() + ends_[owner];
  return {end - counts_[owner], end};
}

void ScanLedger::orderByOwner() {
  ends_.resize(counts_.size());
  std::exclusive_scan(counts_.begin(), counts_.end(), ends_.begin(), 0u);
  std::vector<VoxelRun> ordered(runs_.size());
  for (const VoxelRun& run : runs_) ordered[ends_[run.owner()]++] = run;
  runs_.swap(ordered);
}

}  // namespace toss
