// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/EvidenceCells.h>

#include <cmath>

namespace toss {
namespace {

/// 14 bits per axis (+-8192 cells) and 21 bits of instance; never 0.
std::uint64_t cellKey(float x, float y, float z, std::int32_t instance) {
  const auto bits = [](float value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)) & 0x3FFF);
  };
  return (std::uint64_t{1} << 63) | (static_cast<std::uint64_t>(instance) & 0x1FFFFF) << 42 |
         bits(x) << 28 | bits(y) << 14 | bits(z);
}

bool standsAboveGround(PointClass pointClass) {
  return pointClass == PointClass::Instance || pointClass == PointClass::Unclustered;
}

}  // namespace

std::size_t CellThinning::slotOf(std::uint64_t key) const {
  const std::size_t mask = keys_.size() - 1;
  std::size_t slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> 32) & mask;
  while (keys_[slot] != 0 && keys_[slot] != key) slot = (slot + 1) & mask;
  return slot;
}

void CellThinning::thin(const LevelPoints& points, const Segmentation& segmentation,
                        EvidenceCells& cells) {
  const std::size_t n = segmentation.pointClass.size();
  std::size_t capacity = 1024;
  while (capacity < 2 * n) capacity *= 2;
  keys_.assign(capacity, 0);
  cellOfSlot_.resize(capacity);
  cells.x.clear(), cells.y.clear(), cells.z.clear(), cells.instance.clear();
  cells.cellOfPoint.assign(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    if (!standsAboveGround(segmentation.pointClass[i])) continue;
    const std::int32_t instance = segmentation.instance[i];
    const std::uint64_t key = cellKey(points.x[i] * inverseSize_, points.y[i] * inverseSize_,
                                      points.z[i] * inverseSize_, instance);
    const std::size_t slot = slotOf(key);
    if (keys_[slot] == 0) {
      keys_[slot] = key;
      cellOfSlot_[slot] = static_cast<std::int32_t>(cells.size());
      cells.x.push_back(points.x[i]), cells.y.push_back(points.y[i]);
      cells.z.push_back(points.z[i]), cells.instance.push_back(instance);
    }
    cells.cellOfPoint[i] = cellOfSlot_[slot];
  }
  cells.past.reset(cells.size());
  cells.later.reset(cells.size());
}

std::vector<FreeSpaceSum> sumByInstance(const EvidenceCells& cells, std::int32_t instanceCount,
                                        int minFreeViews) {
  std::vector<FreeSpaceSum> sums(static_cast<std::size_t>(instanceCount) + 1);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    FreeSpaceSum& sum = sums[static_cast<std::size_t>(cells.instance[c])];
    ++sum.cells;
    if (isFree(cells, c, minFreeViews)) ++sum.free;
    if (isHit(cells, c)) ++sum.hit;
  }
  return sums;
}

}  // namespace toss
