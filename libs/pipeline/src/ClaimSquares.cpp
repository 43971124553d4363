// SPDX-License-Identifier: BSD-3-Clause
#include "ClaimSquares.h"

#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <array>

namespace toss {
namespace {

using Mark = std::uint16_t;

constexpr int kCutterShift = 2;
constexpr Mark kOutright = 1, kResidue = 2, kMany = 0xfffc;
/// In the place of an instance's own mark: it is not cut; or it is, but has no mark of its own.
constexpr Mark kNotCut = kMany + 1, kNoMark = 1;
constexpr std::size_t kBlock = 512;
static_assert(ClaimGrid::kCells * ClaimGrid::kCells - 1 <= 0xffff,
              "ClaimReturns::cell holds any cell");
static_assert(static_cast<int>(ClaimWay::Residue) == kResidue &&
                  static_cast<int>(ClaimWay::Any) == (kOutright | kResidue),
              "marks asked for are ways");

Mark cutterOf(std::int32_t instance) {
  const bool named = instance > 0 && instance < kMany >> kCutterShift;
  return named ? static_cast<Mark>(instance << kCutterShift) : kMany;
}

// The compiler vectorises these only as functions of arrays that are known not to overlap.

/// What would have to be marked for a box to claim a return that is in no instance: kOutright or
/// kResidue, which are the bits of a ClaimWay; 0 for returns that are in one, and for those that no
/// box may claim.
TOSS_ALSO_FOR_AVX2
void findAsked(const PointClass* __restrict pointClass, const float* __restrict height,
               float lowGround, std::size_t n, Mark* __restrict asked) {
  for (std::size_t i = 0; i < n; ++i) {
    const int ground = static_cast<int>(pointClass[i] == PointClass::Ground);
    const int outside = ground | static_cast<int>(pointClass[i] == PointClass::Unclustered);
    const int low = ground & static_cast<int>(height[i] <= lowGround);
    asked[i] = static_cast<Mark>(outside * kResidue + (outside ^ low) * kOutright);
  }
}

/// Whether each return may be claimed, by the mark of its square and that of its own box.
TOSS_ALSO_FOR_AVX2
void decide(const Mark* __restrict mark, const Mark* __restrict asked, const Mark* __restrict own,
            std::size_t n, std::uint8_t* __restrict wanted) {
  for (std::size_t i = 0; i < n; ++i) {
    const auto cutter = static_cast<Mark>(mark[i] & kMany);
    const bool cut = (cutter != 0) & (cutter != own[i]) & (own[i] != kNotCut);
    wanted[i] = static_cast<std::uint8_t>(((mark[i] & asked[i]) != 0) | cut);
  }
}

}  // namespace

/// Some returns of the scan.
struct ClaimSquares::Block {
  std::array<std::int32_t, kBlock> square;
  std::array<Mark, kBlock> asked, mark, own;
  std::array<std::uint8_t, kBlock> wanted;
};

void ClaimSquares::clear() {
  marks_.assign(static_cast<std::size_t>(ClaimGrid::kSquares) * ClaimGrid::kSquares, 0);
}

void ClaimSquares::mark(const ClaimFootprint& footprint, const Reach& reach) {
  const float margin = reach.margin + ClaimGrid::kRounding;
  const Eigen::AlignedBox2f around = footprint.extent(margin);
  const auto outside = static_cast<Mark>(kOutright | (reach.residue ? kResidue : 0));
  const Mark cutter = reach.cuts ? cutterOf(reach.instance) : Mark{0};
  const std::int32_t first = ClaimGrid::along(around.min().x());
  const std::int32_t last = ClaimGrid::along(around.max().x());
  for (std::int32_t row = first; row <= last; ++row) {
    const float low = row == first ? around.min().x() : ClaimGrid::beginOf(row);
    const float high = row == last ? around.max().x() : ClaimGrid::beginOf(row + 1);
    const ClaimFootprint::Span span = footprint.between(low, high, margin);
    if (!(span.low <= span.high)) continue;
    Mark* const squares = marks_.data() + static_cast<std::ptrdiff_t>(row) * ClaimGrid::kSquares;
    Mark* const end = squares + ClaimGrid::along(span.high) + 1;
    for (Mark* mark = squares + ClaimGrid::along(span.low); mark != end; ++mark) {
      const Mark before = *mark & kMany;
      const Mark both = before == 0 || before == cutter ? cutter : kMany;
      *mark = static_cast<Mark>(*mark | outside | (cutter == 0 ? 0 : both));
    }
  }
}

void ClaimSquares::findOwnMarks(const std::vector<bool>& cuttable) {
  ownMark_.resize(cuttable.size());
  for (std::size_t k = 0; k < cuttable.size(); ++k) {
    const Mark own = cutterOf(static_cast<std::int32_t>(k));
    ownMark_[k] = !cuttable[k] ? kNotCut : own == kMany ? kNoMark : own;
  }
  ownMark_[0] = kNotCut;
}

void ClaimSquares::findInBlock(const LevelPoints& points, const Segmentation& segmentation,
                               float lowGround, std::size_t begin, std::size_t size,
                               ClaimReturns& found) const {
  Block block;
  ClaimGrid::findSquares(points.x.data() + begin, points.y.data() + begin, size,
                         block.square.data());
  findAsked(segmentation.pointClass.data() + begin, segmentation.heightAboveGround.data() + begin,
            lowGround, size, block.asked.data());
  const std::int32_t* const instance = segmentation.instance.data() + begin;
  for (std::size_t i = 0; i < size; ++i)
    block.mark[i] = marks_[static_cast<std::size_t>(block.square[i])];
  for (std::size_t i = 0; i < size; ++i)
    block.own[i] = ownMark_[static_cast<std::size_t>(instance[i])];
  decide(block.mark.data(), block.asked.data(), block.own.data(), size, block.wanted.data());
  std::fill(block.wanted.begin() + size, block.wanted.end(), std::uint8_t{0});
  std::size_t next = found.count;
  visitMarks(block.wanted.data(), kBlock, [&](std::size_t i) {
    const std::size_t point = begin + i;
    found.point[next] = static_cast<std::int32_t>(point);
    found.way[next] = static_cast<ClaimWay>(block.asked[i]);
    found.x[next] = points.x[point], found.y[next] = points.y[point];
    found.z[next] = points.z[point];
    found.cell[next] = static_cast<std::uint16_t>(ClaimGrid::cellOfSquare(block.square[i]));
    ++next;
  });
  found.count = next;
}

/// Without branches, as no one could foretell where one begins.
void ClaimSquares::findStretches(ClaimReturns& found) {
  std::int32_t last = -1;
  for (std::size_t i = 0; i < found.count; ++i) {
    found.stretch[found.stretchCount] = static_cast<std::int32_t>(i);
    found.stretchCount += found.cell[i] != last;
    last = found.cell[i];
  }
  found.stretch[found.stretchCount] = static_cast<std::int32_t>(found.count);
}

void ClaimSquares::find(const LevelPoints& points, const Segmentation& segmentation,
                        float lowGround, const std::vector<bool>& cuttable, ClaimReturns& found) {
  const std::size_t n = points.x.size();
  findOwnMarks(cuttable);
  found.clear(n);
  for (std::size_t begin = 0; begin < n; begin += kBlock)
    findInBlock(points, segmentation, lowGround, begin, std::min(kBlock, n - begin), found);
  findStretches(found);
}

}  // namespace toss
