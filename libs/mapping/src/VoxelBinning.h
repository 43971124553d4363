// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "CrowdedVoxels.h"
#include "VoxelRuns.h"

namespace toss {

/// Sums returns by owner and voxel as far as they are neighbours in the scan. Keeps its buffers
/// from call to call; one per thread.
class VoxelBinning {
 public:
  /// Replaces `result` by runs that hold at most `cap` returns per owner and voxel, the first
  /// first. Returns how many returns were left out because they are not finite or out of reach.
  std::size_t bin(const VoxelReturns& returns, std::uint32_t cap, BinnedReturns& result);

 private:
  void limitCrowded(const VoxelReturns& returns, BinnedReturns& result);
  void findCrowdedChunks(const BinnedReturns& result);

  VoxelRuns runs_;
  CrowdedVoxels crowded_;
  /// Runs of the chunks so far, permanent and owned, after each chunk of returns.
  std::vector<std::array<std::size_t, 2>> chunkEnds_;
  /// Chunks that hold returns of voxels that may be crowded.
  std::vector<std::size_t> crowdedChunks_;
  /// Runs of the scan before: permanent, owned.
  std::array<std::size_t, 2> sizes_{};
};

}  // namespace toss
