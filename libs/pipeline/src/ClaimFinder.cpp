// SPDX-License-Identifier: BSD-3-Clause
#include "ClaimFinder.h"

#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <array>

#include "ClaimGrid.h"

namespace toss {
namespace {

/// The lowest part of an object lies in the ground layer or is too sparse to be in its instance.
constexpr double kBelowBox = 1.0;
/// What a square is marked with, and what a return asks its square for.
constexpr std::uint8_t kObjects = 1, kGround = 2;

// The compiler vectorises these only as functions of arrays that are known not to overlap.

TOSS_ALSO_FOR_AVX2
void findAsked(const PointClass* __restrict pointClass, std::size_t n,
               std::uint8_t* __restrict asked) {
  for (std::size_t i = 0; i < n; ++i) {
    const int object = static_cast<int>(pointClass[i] == PointClass::Unclustered) |
                       static_cast<int>(pointClass[i] == PointClass::Instance);
    const int ground = static_cast<int>(pointClass[i] == PointClass::Ground);
    asked[i] = static_cast<std::uint8_t>(object * kObjects | ground * kGround);
  }
}

TOSS_ALSO_FOR_AVX2
void findWanted(const std::uint8_t* __restrict asked, const std::uint8_t* __restrict mark,
                std::size_t n, std::uint8_t* __restrict wanted) {
  for (std::size_t i = 0; i < n; ++i)
    wanted[i] = static_cast<std::uint8_t>((asked[i] & mark[i]) != 0);
}

}  // namespace

const std::vector<Claim>& ClaimFinder::find(const std::vector<Claimant>& claimants,
                                            const ScanRecord& record,
                                            const std::vector<bool>& moving) {
  claims_.clear();
  if (claimants.empty()) return claims_;
  enter(claimants, record.sensorPosition);
  visitNearby(record, [&](std::size_t i) {
    if (moving[record.owner[i]]) return;
    const LevelPoints& level = record.level;
    const std::int32_t claimant =
        boxAround({level.x[i], level.y[i], level.z[i]}, record.pointClass[i] == PointClass::Ground);
    if (claimant >= 0) claims_.push_back({static_cast<std::int32_t>(i), claimant});
  });
  return claims_;
}

void ClaimFinder::enter(const std::vector<Claimant>& claimants,
                        const Eigen::Vector3d& sensorPosition) {
  marks_.assign(static_cast<std::size_t>(ClaimGrid::kSquares) * ClaimGrid::kSquares, 0);
  firstEntry_.resize(static_cast<std::size_t>(ClaimGrid::kCells) * ClaimGrid::kCells, -1);
  for (const std::size_t cell : usedCells_) firstEntry_[cell] = -1;
  usedCells_.clear(), entries_.clear(), footprints_.clear(), takesGround_.clear();
  byVolume_.clear();
  for (const Claimant& claimant : claimants) {
    const auto number = static_cast<std::int32_t>(footprints_.size());
    footprints_.emplace_back(claimant.box, sensorPosition, kBelowBox);
    takesGround_.push_back(claimant.ground);
    byVolume_.emplace_back(-claimant.box.volume(), number);
  }
  std::sort(byVolume_.begin(), byVolume_.end());
  // Entered last means found first: larger boxes go in before smaller ones.
  for (const auto& [volume, number] : byVolume_)
    enter(claimants[static_cast<std::size_t>(number)], number);
}

void ClaimFinder::enter(const Claimant& claimant, std::int32_t number) {
  const Eigen::AlignedBox2f area =
      footprints_[static_cast<std::size_t>(number)].extent(margin_ + ClaimGrid::kRounding);
  const auto mark = static_cast<std::uint8_t>(claimant.ground ? kObjects | kGround : kObjects);
  ClaimGrid::visitSquares(area, [&](std::size_t square) { marks_[square] |= mark; });
  ClaimGrid::visitCells(area, [&](std::size_t cell) {
    if (firstEntry_[cell] < 0) usedCells_.push_back(cell);
    entries_.push_back({number, firstEntry_[cell]});
    firstEntry_[cell] = static_cast<std::int32_t>(entries_.size()) - 1;
  });
}

template <typename Visit>
void ClaimFinder::visitNearby(const ScanRecord& record, Visit&& visit) const {
  constexpr std::size_t kBlock = 4 * kMarksInBlock;
  std::array<std::int32_t, kBlock> square;
  std::array<std::uint8_t, kBlock> asked, mark, wanted{};
  const std::size_t n = record.owner.size();
  for (std::size_t begin = 0; begin < n; begin += kBlock) {
    const std::size_t size = std::min(kBlock, n - begin);
    findAsked(record.pointClass.data() + begin, size, asked.data());
    ClaimGrid::findSquares(record.level.x.data() + begin, record.level.y.data() + begin, size,
                           square.data());
    for (std::size_t i = 0; i < size; ++i) mark[i] = marks_[static_cast<std::size_t>(square[i])];
    findWanted(asked.data(), mark.data(), size, wanted.data());
    std::fill(wanted.begin() + size, wanted.end(), std::uint8_t{0});
    visitMarks(wanted.data(), kBlock, [&](std::size_t i) { visit(begin + i); });
  }
}

std::int32_t ClaimFinder::boxAround(const Eigen::Vector3f& point, bool ground) const {
  const std::int32_t square = ClaimGrid::squareOf(point.x(), point.y());
  for (std::int32_t e = firstEntry_[ClaimGrid::cellOfSquare(square)]; e >= 0;) {
    const Entry& entry = entries_[static_cast<std::size_t>(e)];
    const auto box = static_cast<std::size_t>(entry.box);
    if ((!ground || takesGround_[box]) && footprints_[box].holds(point, margin_)) return entry.box;
    e = entry.next;
  }
  return -1;
}

}  // namespace toss
