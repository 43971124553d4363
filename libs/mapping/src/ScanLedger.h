// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// Runs of the owners of one scan: as they came, until the first owner is asked for.
class ScanLedger {
 public:
  /// Takes `runs` and leaves memory of what was held before in their place.
  void swap(std::vector<VoxelRun>& runs);
  /// One more than the greatest owner that has runs.
  std::size_t owners() const { return counts_.size(); }
  /// Runs of an owner: how many, and which.
  std::size_t count(std::size_t owner) const { return owner < owners() ? counts_[owner] : 0; }
  RunSpan of(std::size_t owner);
  const std::vector<VoxelRun>& all() const { return runs_; }

 private:
  void orderByOwner();

  std::vector<VoxelRun> runs_;
  std::vector<std::uint32_t> counts_;
  /// Where the runs of each owner end; empty = they are as they came.
  std::vector<std::uint32_t> ends_;
};

}  // namespace toss
