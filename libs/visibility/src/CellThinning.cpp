// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/CellThinning.h>

#include <algorithm>

namespace toss {
namespace {

/// Cell number along one axis in 14 bits: cells that are 2^14 apart share a number.
std::uint64_t axisBits(float inCells) {
  const auto towardsZero = static_cast<std::int32_t>(inCells);
  const std::int32_t floor = towardsZero - (inCells < static_cast<float>(towardsZero) ? 1 : 0);
  return static_cast<std::uint64_t>(floor & 0x3FFF);
}

void addCell(const LevelPoints& points, std::int32_t point, std::int32_t instance,
             EvidenceCells& cells) {
  const auto i = static_cast<std::size_t>(point);
  cells.x.push_back(points.x[i]), cells.y.push_back(points.y[i]), cells.z.push_back(points.z[i]);
  cells.instance.push_back(instance);
}

}  // namespace

std::uint64_t CellThinning::keyOf(const LevelPoints& points, std::size_t point) const {
  return (std::uint64_t{1} << 42) | axisBits(points.x[point] * inverseSize_) << 28 |
         axisBits(points.y[point] * inverseSize_) << 14 | axisBits(points.z[point] * inverseSize_);
}

void CellThinning::startTable(std::size_t count) {
  shift_ = 60;
  while ((std::size_t{1} << (64 - shift_)) < 2 * count) --shift_;
  const std::size_t slots = std::size_t{1} << (64 - shift_);
  if (keys_.size() < slots) keys_.resize(slots), cellOfSlot_.resize(slots);
  std::fill_n(keys_.begin(), slots, 0);
  firstPoint_.clear();
}

std::int32_t CellThinning::cellOf(std::uint64_t key, std::int32_t point) {
  const std::size_t mask = (std::size_t{1} << (64 - shift_)) - 1;
  std::size_t slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> shift_);
  while (keys_[slot] != 0 && keys_[slot] != key) slot = (slot + 1) & mask;
  if (keys_[slot] == 0) {
    keys_[slot] = key;
    cellOfSlot_[slot] = static_cast<std::int32_t>(firstPoint_.size());
    firstPoint_.push_back(point);
  }
  return cellOfSlot_[slot];
}

void CellThinning::thinUnclustered(const LevelPoints& points, const Segmentation& segmentation,
                                   EvidenceCells& cells) {
  const std::size_t n = segmentation.pointClass.size();
  for (std::size_t i = 0; i < n; ++i)
    if (segmentation.pointClass[i] == PointClass::Unclustered)
      cells.lonePoint.push_back(static_cast<std::int32_t>(i));
  startTable(cells.lonePoint.size());
  for (const std::int32_t i : cells.lonePoint)
    cells.loneCell.push_back(cellOf(keyOf(points, static_cast<std::size_t>(i)), i));
  for (const std::int32_t point : firstPoint_) addCell(points, point, 0, cells);
}

void CellThinning::thinInstance(const LevelPoints& points, const std::int32_t* begin,
                                const std::int32_t* end, std::int32_t instance,
                                EvidenceCells& cells) {
  startTable(static_cast<std::size_t>(end - begin));
  std::uint64_t last = 0;
  for (const std::int32_t* point = begin; point != end; ++point) {
    const std::uint64_t key = keyOf(points, static_cast<std::size_t>(*point));
    // Neighbours along a row mostly share their cell.
    if (key != last) cellOf(key, *point);
    last = key;
  }
  const std::size_t stride = 1 + (firstPoint_.size() - 1) / maxCells_;
  for (std::size_t c = 0; c < firstPoint_.size(); c += stride)
    addCell(points, firstPoint_[c], instance, cells);
}

void CellThinning::thin(const LevelPoints& points, const Segmentation& segmentation,
                        EvidenceCells& cells) {
  cells.x.clear(), cells.y.clear(), cells.z.clear(), cells.instance.clear();
  cells.lonePoint.clear(), cells.loneCell.clear();
  thinUnclustered(points, segmentation, cells);
  const std::int32_t* members = segmentation.members.data();
  for (std::int32_t k = 1; k <= segmentation.instanceCount; ++k) {
    const std::int32_t* begin = &segmentation.memberBegin[static_cast<std::size_t>(k) - 1];
    thinInstance(points, members + begin[0], members + begin[1], k, cells);
  }
  cells.past.reset(cells.size());
  cells.later.reset(cells.size());
}

}  // namespace toss
