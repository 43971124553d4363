// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBinning.h"

namespace toss {

namespace {

void addTo(VoxelContribution& sum, const VoxelContribution& part) {
  sum.count += part.count;
  sum.x += part.x;
  sum.y += part.y;
  sum.z += part.z;
  sum.intensity += part.intensity;
}

std::size_t inBrick(VoxelKey key) {
  return static_cast<std::size_t>(key & ((1u << kBrickShift) - 1));
}

/// The first `count` returns of a run.
VoxelContribution beginOf(const VoxelRun& run, const VoxelReturns& returns, std::uint32_t count) {
  std::vector<VoxelRun> part;
  appendRuns(returns, run.begin, run.end, count, part);
  return part.front().sum;
}

}  // namespace

std::size_t VoxelBinning::sum(const VoxelReturns& returns, std::uint32_t cap,
                              BinnedReturns& result) {
  result.permanent.clear();
  result.contributions.clear();
  result.owners.clear();
  runs_.clear();
  const std::size_t leftOut = appendRuns(returns, 0, returns.count, cap, runs_);
  for (const RunGrouping::Group& brick : grouping_.byOwnerAndBrick(runs_)) {
    const std::uint32_t owner = brick.begin->owner;
    std::vector<VoxelContribution>& sums = owner == 0 ? result.permanent : result.contributions;
    if (owner != 0 && (result.owners.empty() || result.owners.back().owner != owner))
      result.owners.push_back({owner, sums.size(), sums.size()});
    makePlaces(brick, sums);
    addBrick(returns, brick, cap, sums);
    if (owner != 0) result.owners.back().end = sums.size();
  }
  return leftOut;
}

void VoxelBinning::makePlaces(const RunGrouping::Group& brick,
                              std::vector<VoxelContribution>& result) {
  constexpr std::size_t kWords = (1u << kBrickShift) / 64;
  std::uint64_t voxels[kWords] = {}, words = 0;
  for (const VoxelRun* run = brick.begin; run != brick.end; ++run) {
    const std::size_t voxel = inBrick(run->sum.key);
    voxels[voxel / 64] |= std::uint64_t{1} << voxel % 64;
    words |= std::uint64_t{1} << voxel / 64;
  }
  const VoxelKey brickKey = brick.begin->sum.key >> kBrickShift << kBrickShift;
  for (; words != 0; words &= words - 1) {
    const auto word = static_cast<std::size_t>(__builtin_ctzll(words));
    for (std::uint64_t left = voxels[word]; left != 0; left &= left - 1) {
      const std::size_t voxel = 64 * word + static_cast<std::size_t>(__builtin_ctzll(left));
      placeOf_[voxel] = static_cast<std::uint32_t>(result.size());
      result.emplace_back();
      result.back().key = brickKey | voxel;
    }
  }
}

void VoxelBinning::addBrick(const VoxelReturns& returns, const RunGrouping::Group& brick,
                            std::uint32_t cap, std::vector<VoxelContribution>& result) const {
  for (const VoxelRun* run = brick.begin; run != brick.end; ++run) {
    VoxelContribution& sum = result[placeOf_[inBrick(run->sum.key)]];
    const std::uint32_t room = cap - sum.count;
    if (room == 0) continue;
    addTo(sum, run->sum.count <= room ? run->sum : beginOf(*run, returns, room));
  }
}

}  // namespace toss
