// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>
#include <toss/visibility/EvidenceCells.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Makes the cells of scans; keeps its tables from scan to scan.
class CellThinning {
 public:
  /// `cellSize` [m]; `maxCells`: most cells of one instance.
  CellThinning(double cellSize, int maxCells)
      : inverseSize_(static_cast<float>(1.0 / cellSize)),
        maxCells_(static_cast<std::size_t>(maxCells)) {}

  /// Replaces `cells`; the first return of a cell stands for it, and of instances with more than
  /// the most cells every so manieth cell for all. All counts are 0.
  void thin(const LevelPoints& points, const Segmentation& segmentation, EvidenceCells& cells);

 private:
  struct Block;
  /// An entry of the table of cells: its key below the number of the round that made it.
  struct Slot {
    std::uint64_t key = 0;
    std::int32_t cell = 0;
  };
  /// Calls visit(point, key of its cell) for each of some points, or with `onlyChanges` for those
  /// that are not in the cell of the one before: neighbours along a row mostly share theirs.
  template <typename Visit>
  void visitKeys(const LevelPoints& points, const std::int32_t* begin, const std::int32_t* end,
                 bool onlyChanges, Visit&& visit) const;
  /// Forgets all cells; then up to `count` may come.
  void startTable(std::size_t count);
  /// Number of the cell with that key, in order of their coming; a new one is met at `point`.
  std::int32_t cellOf(std::uint64_t key, std::int32_t point);
  void thinUnclustered(const LevelPoints& points, const Segmentation& segmentation,
                       EvidenceCells& cells);
  void thinInstance(const LevelPoints& points, const std::int32_t* begin, const std::int32_t* end,
                    std::int32_t instance, EvidenceCells& cells);
  void takeCoordinates(const LevelPoints& points, EvidenceCells& cells) const;

  float inverseSize_;
  std::size_t maxCells_;
  /// Open addressing in the first 2^(64 - shift_) slots; those of other rounds are free.
  std::vector<Slot> slots_;
  std::uint64_t round_ = 0;
  int shift_ = 64;
  /// First point of each cell met so far.
  std::vector<std::int32_t> firstPoint_;
  /// Points that stand for the cells of the scan.
  std::vector<std::int32_t> picked_;
};

}  // namespace toss
