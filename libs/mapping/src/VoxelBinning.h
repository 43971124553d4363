// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RunGrouping.h"
#include "VoxelRuns.h"

namespace toss {

/// Sums returns by owner and voxel: neighbours of a scan first, then by the bricks in which they
/// lie, so that few things are sorted. Keeps its buffers from call to call; one per thread.
class VoxelBinning {
 public:
  /// Replaces `result` by the sums of each voxel by ascending owner and key, of at most `cap`
  /// returns each, the first first. Returns how many returns were left out.
  std::size_t sum(const VoxelReturns& returns, std::uint32_t cap, BinnedReturns& result);

 private:
  /// Appends an empty sum to `result` for each voxel of a brick and notes its place.
  void makePlaces(const RunGrouping::Group& brick, std::vector<VoxelContribution>& result);
  void addBrick(const VoxelReturns& returns, const RunGrouping::Group& brick, std::uint32_t cap,
                std::vector<VoxelContribution>& result) const;

  std::vector<VoxelRun> runs_;
  RunGrouping grouping_;
  /// Place in the result of each voxel of the present brick, by the lower bits of its key.
  std::uint32_t placeOf_[1 << kBrickShift];
};

}  // namespace toss
