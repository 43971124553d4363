// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>
#include <toss/visibility/EvidenceCells.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

/// Makes the cells of scans; keeps its tables from scan to scan.
class CellThinning {
 public:
  /// `cellSize` [m]; `maxCells`: most cells of one instance. Nothing is asked about what is more
  /// than `maxClearance` [m] above the ground, lone returns and whole instances: nothing that moves
  /// is there, but twigs through which other views see.
  CellThinning(double cellSize, int maxCells,
               double maxClearance = std::numeric_limits<double>::infinity())
      : inverseSize_(static_cast<float>(1.0 / cellSize)),
        maxCells_(static_cast<std::size_t>(maxCells)),
        maxClearance_(static_cast<float>(maxClearance)) {}

  /// Replaces `cells`; the first return of a cell stands for it, and of instances with more than
  /// the most cells every so manieth cell for all. Of an instance with over 16 returns for each of
  /// the most cells, so many are looked at, evenly in order of the scan. All counts are 0.
  void thin(const LevelPoints& points, const Segmentation& segmentation, EvidenceCells& cells);

 private:
  struct Block;
  /// Calls visit(point, key of its cell) for each of some points, or with `onlyChanges` for those
  /// that are not in the cell of the one before: neighbours along a row mostly share theirs.
  template <typename Visit>
  void visitKeys(const LevelPoints& points, const std::int32_t* begin, const std::int32_t* end,
                 bool onlyChanges, Visit&& visit) const;
  /// Forgets all cells; then up to `count` may come.
  void startTable(std::size_t count);
  /// Slot of the cell with that key; a new one is met at `point`.
  std::size_t slotOf(std::uint64_t key, std::int32_t point);
  /// Where it is looked for first.
  std::size_t firstSlot(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ull) >> shift_);
  }
  void thinUnclustered(const LevelPoints& points, const Segmentation& segmentation,
                       EvidenceCells& cells);
  void thinInstance(const LevelPoints& points, const std::int32_t* begin, const std::int32_t* end,
                    std::int32_t instance, EvidenceCells& cells);
  void takeCoordinates(const LevelPoints& points, const Segmentation& segmentation,
                       EvidenceCells& cells) const;

  float inverseSize_;
  std::size_t maxCells_;
  float maxClearance_;
  /// Table of cells: the key of each below the number of the round that made it. Open addressing in
  /// the first 2^(64 - shift_) slots; those of other rounds are free.
  std::vector<std::uint64_t> slots_;
  /// Number of the cell in each slot, where it is asked for.
  std::vector<std::int32_t> cellInSlot_;
  std::uint64_t round_ = 0;
  int shift_ = 64;
  /// First point of each cell met so far.
  std::vector<std::int32_t> firstPoint_;
  /// Returns of an instance that has more than are looked at.
  std::vector<std::int32_t> sample_;
  /// Points that stand for the cells of the scan.
  std::vector<std::int32_t> picked_;
};

}  // namespace toss
