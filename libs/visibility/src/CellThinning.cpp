// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/visibility/CellThinning.h>

#include <algorithm>
#include <array>

namespace toss {
namespace {

/// Bits of a cell number along one axis: cells that are 2^14 apart share a number.
constexpr int kAxisBits = 14;
constexpr std::int32_t kAxisMask = (1 << kAxisBits) - 1;
/// Bits of a cell's key, above which stands the number of its round.
constexpr int kKeyBits = 3 * kAxisBits;
constexpr std::uint64_t kRounds = std::uint64_t{1} << (64 - kKeyBits);
/// Returns of an instance that are looked at for each cell that it may have.
constexpr std::size_t kLooksPerCell = 16;

/// Cell number along one axis, rounded down by hand: calls of std::floor take long.
std::int32_t axisBits(float inCells) {
  const auto towardsZero = static_cast<std::int32_t>(inCells);
  return (towardsZero - static_cast<int>(inCells < static_cast<float>(towardsZero))) & kAxisMask;
}

}  // namespace

/// Some returns, and the number of the cell of each: along x, and along y and z together.
struct CellThinning::Block {
  static constexpr std::size_t kMost = 128;
  std::array<float, kMost> x, y, z;
  std::array<std::int32_t, kMost> alongX, alongYZ;
  /// Points that were chosen, and the keys of their cells.
  std::array<std::int32_t, kMost> point;
  std::array<std::uint64_t, kMost> key;

  void gather(const LevelPoints& points, const std::int32_t* all, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto p = static_cast<std::size_t>(all[i]);
      x[i] = points.x[p], y[i] = points.y[p], z[i] = points.z[p];
    }
  }
  void findCells(float cellsPerMetre, std::size_t count);
  /// Lists points with their keys, or only those whose key is not that of the point before, `last`
  /// at first; returns how many. Without branches, as no one could foretell which these are.
  std::size_t choose(const std::int32_t* all, std::size_t count, bool onlyChanges,
                     std::uint64_t& last) {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t own = static_cast<std::uint64_t>(alongX[i]) << (2 * kAxisBits) |
                                static_cast<std::uint64_t>(alongYZ[i]);
      point[chosen] = all[i], key[chosen] = own;
      chosen += static_cast<std::size_t>(!onlyChanges | (own != last));
      last = own;
    }
    return chosen;
  }
};

/// The compiler vectorises it only as a function of its own.
TOSS_ALSO_FOR_AVX2
void CellThinning::Block::findCells(float cellsPerMetre, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    alongX[i] = axisBits(x[i] * cellsPerMetre);
    alongYZ[i] = axisBits(y[i] * cellsPerMetre) << kAxisBits | axisBits(z[i] * cellsPerMetre);
  }
}

/// Slots of earlier rounds are free, so that none has to be cleared.
void CellThinning::startTable(std::size_t count) {
  shift_ = 60;
  while ((std::size_t{1} << (64 - shift_)) < 2 * count) --shift_;
  const std::size_t slots = std::size_t{1} << (64 - shift_);
  if (++round_ == kRounds) {
    std::fill(slots_.begin(), slots_.end(), 0);
    round_ = 1;
  }
  if (slots_.size() < slots) slots_.resize(slots), cellInSlot_.resize(slots);
  firstPoint_.clear();
}

std::size_t CellThinning::slotOf(std::uint64_t key, std::int32_t point) {
  const std::size_t mask = (std::size_t{1} << (64 - shift_)) - 1;
  const std::uint64_t ownKey = round_ << kKeyBits | key;
  std::size_t slot = firstSlot(key);
  while (slots_[slot] != ownKey) {
    if (slots_[slot] >> kKeyBits != round_) {
      slots_[slot] = ownKey;
      firstPoint_.push_back(point);
      return slot;
    }
    slot = (slot + 1) & mask;
  }
  return slot;
}

template <typename Visit>
void CellThinning::visitKeys(const LevelPoints& points, const std::int32_t* begin,
                             const std::int32_t* end, bool onlyChanges, Visit&& visit) const {
  Block block;
  std::uint64_t last = ~std::uint64_t{0};
  while (begin != end) {
    const auto count = std::min(Block::kMost, static_cast<std::size_t>(end - begin));
    block.gather(points, begin, count);
    block.findCells(inverseSize_, count);
    const std::size_t chosen = block.choose(begin, count, onlyChanges, last);
    for (std::size_t i = 0; i < chosen; ++i) __builtin_prefetch(&slots_[firstSlot(block.key[i])]);
    for (std::size_t i = 0; i < chosen; ++i) visit(block.point[i], block.key[i]);
    begin += count;
  }
}

void CellThinning::thinUnclustered(const LevelPoints& points, const Segmentation& segmentation,
                                   EvidenceCells& cells) {
  const std::size_t n = segmentation.pointClass.size();
  for (std::size_t i = 0; i < n; ++i)
    if (segmentation.pointClass[i] == PointClass::Unclustered &&
        clearanceOf(i, points, segmentation) <= maxClearance_)
      cells.lonePoint.push_back(static_cast<std::int32_t>(i));
  startTable(cells.lonePoint.size());
  const std::int32_t* const lone = cells.lonePoint.data();
  const auto cellOf = [&](std::int32_t point, std::uint64_t key) {
    const auto next = static_cast<std::int32_t>(firstPoint_.size());
    const std::size_t slot = slotOf(key, point);
    if (static_cast<std::size_t>(next) < firstPoint_.size()) cellInSlot_[slot] = next;
    cells.loneCell.push_back(cellInSlot_[slot]);
  };
  visitKeys(points, lone, lone + cells.lonePoint.size(), false, cellOf);
  picked_ = firstPoint_;
  cells.instance.assign(picked_.size(), 0);
}

void CellThinning::thinInstance(const LevelPoints& points, const std::int32_t* begin,
                                const std::int32_t* end, std::int32_t instance,
                                EvidenceCells& cells) {
  // Of walls with thousands of returns a few per cell find as many cells as are asked for.
  const auto count = static_cast<std::size_t>(end - begin), most = kLooksPerCell * maxCells_;
  if (count > most) {
    sample_.resize(most);
    for (std::size_t i = 0; i < most; ++i) sample_[i] = begin[i * count / most];
    begin = sample_.data(), end = begin + most;
  }
  startTable(static_cast<std::size_t>(end - begin));
  visitKeys(points, begin, end, true,
            [&](std::int32_t point, std::uint64_t key) { slotOf(key, point); });
  const std::size_t stride = 1 + (firstPoint_.size() - 1) / maxCells_;
  for (std::size_t c = 0; c < firstPoint_.size(); c += stride) picked_.push_back(firstPoint_[c]);
  cells.instance.resize(picked_.size(), instance);
}

void CellThinning::takeCoordinates(const LevelPoints& points, const Segmentation& segmentation,
                                   EvidenceCells& cells) const {
  const std::size_t n = picked_.size();
  cells.x.resize(n), cells.y.resize(n), cells.z.resize(n);
  cells.heightAboveGround.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    const auto point = static_cast<std::size_t>(picked_[c]);
    cells.x[c] = points.x[point], cells.y[c] = points.y[point], cells.z[c] = points.z[point];
    cells.heightAboveGround[c] = segmentation.knownHeight(point);
  }
}

void CellThinning::thin(const LevelPoints& points, const Segmentation& segmentation,
                        EvidenceCells& cells) {
  cells.lonePoint.clear(), cells.loneCell.clear();
  thinUnclustered(points, segmentation, cells);
  const std::int32_t* members = segmentation.members.data();
  for (std::int32_t k = 1; k <= segmentation.instanceCount; ++k) {
    if (isFloating(k, maxClearance_, points, segmentation)) continue;
    const std::int32_t* begin = &segmentation.memberBegin[static_cast<std::size_t>(k) - 1];
    thinInstance(points, members + begin[0], members + begin[1], k, cells);
  }
  takeCoordinates(points, segmentation, cells);
  cells.past.reset(cells.size());
  cells.later.reset(cells.size());
}

}  // namespace toss
