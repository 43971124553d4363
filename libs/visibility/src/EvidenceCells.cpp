// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/EvidenceCells.h>

#include <algorithm>
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
    if (instance == 0) cells.cellOfPoint[i] = cellOfSlot_[slot];
  }
  sample(segmentation.instanceCount, cells);
  cells.past.reset(cells.size());
  cells.later.reset(cells.size());
}

void CellThinning::sample(std::int32_t instanceCount, EvidenceCells& cells) {
  const auto groups = static_cast<std::size_t>(instanceCount) + 1;
  met_.assign(groups, 0);
  for (const std::int32_t instance : cells.instance) ++met_[static_cast<std::size_t>(instance)];
  stride_.resize(groups);
  for (std::size_t k = 0; k < groups; ++k) stride_[k] = k == 0 ? 1 : 1 + (met_[k] - 1) / maxCells_;
  std::fill(met_.begin(), met_.end(), 0);
  std::vector<std::int32_t> placeOfCell(cells.size(), -1);
  std::size_t kept = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto k = static_cast<std::size_t>(cells.instance[c]);
    if (met_[k]++ % stride_[k] != 0) continue;
    placeOfCell[c] = static_cast<std::int32_t>(kept);
    cells.x[kept] = cells.x[c], cells.y[kept] = cells.y[c], cells.z[kept] = cells.z[c];
    cells.instance[kept++] = cells.instance[c];
  }
  cells.x.resize(kept), cells.y.resize(kept), cells.z.resize(kept), cells.instance.resize(kept);
  for (std::int32_t& cell : cells.cellOfPoint)
    if (cell >= 0) cell = placeOfCell[static_cast<std::size_t>(cell)];
}

std::vector<FreeSpaceSum> sumByInstance(const EvidenceCells& cells, std::int32_t instanceCount,
                                        int minFreeViews) {
  std::vector<FreeSpaceSum> sums(static_cast<std::size_t>(instanceCount) + 1);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    FreeSpaceSum& sum = sums[static_cast<std::size_t>(cells.instance[c])];
    ++sum.cells;
    if (isFree(cells, c, minFreeViews))
      ++sum.free;
    else if (isHit(cells, c))
      ++sum.hit;
  }
  return sums;
}

}  // namespace toss
