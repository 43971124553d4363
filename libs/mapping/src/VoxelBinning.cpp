// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBinning.h"

#include <algorithm>

namespace toss {

std::size_t VoxelBinning::bin(const VoxelReturns& returns, std::uint32_t cap,
                              BinnedReturns& result) {
  std::vector<VoxelRun>* const parts[] = {&result.permanent, &result.owned};
  for (std::size_t part : {0, 1}) {
    parts[part]->clear();
    // Scans are much alike: memory is taken once.
    parts[part]->reserve(sizes_[part] + sizes_[part] / 8);
  }
  crowded_.clear(cap);
  chunkEnds_.clear();
  const std::size_t before = runs_.leftOut();
  for (std::size_t begin = 0; begin < returns.count; begin += VoxelRuns::kChunk) {
    for (const VoxelRun& run : runs_.of(returns, begin, VoxelRun::kMostReturns)) {
      crowded_.count(run);
      parts[run.owner() != 0]->push_back(run);
    }
    chunkEnds_.push_back({parts[0]->size(), parts[1]->size()});
  }
  const std::size_t leftOut = runs_.leftOut() - before;
  if (crowded_.any()) limitCrowded(returns, result);
  for (std::size_t part : {0, 1}) sizes_[part] = parts[part]->size();
  return leftOut;
}

void VoxelBinning::findCrowdedChunks(const BinnedReturns& result) {
  crowdedChunks_.clear();
  const std::vector<VoxelRun>* const parts[] = {&result.permanent, &result.owned};
  std::array<std::size_t, 2> begin{};
  for (std::size_t chunk = 0; chunk < chunkEnds_.size(); ++chunk) {
    const auto holdsCrowded = [&](std::size_t part) {
      const auto first = parts[part]->begin();
      return std::any_of(first + static_cast<std::ptrdiff_t>(begin[part]),
                         first + static_cast<std::ptrdiff_t>(chunkEnds_[chunk][part]),
                         [&](const VoxelRun& run) { return crowded_.has(run); });
    };
    if (holdsCrowded(0) || holdsCrowded(1)) crowdedChunks_.push_back(chunk);
    begin = chunkEnds_[chunk];
  }
}

void VoxelBinning::limitCrowded(const VoxelReturns& returns, BinnedReturns& result) {
  findCrowdedChunks(result);
  for (std::vector<VoxelRun>* part : {&result.permanent, &result.owned})
    part->erase(std::remove_if(part->begin(), part->end(),
                               [&](const VoxelRun& run) { return crowded_.has(run); }),
                part->end());
  for (const std::size_t chunk : crowdedChunks_)
    for (const VoxelRun& single : runs_.of(returns, chunk * VoxelRuns::kChunk, 1))
      if (crowded_.has(single)) crowded_.add(single);
  crowded_.visit([&](const VoxelRun& run) {
    (run.owner() == 0 ? result.permanent : result.owned).push_back(run);
  });
}

}  // namespace toss
