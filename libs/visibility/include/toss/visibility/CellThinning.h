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
  /// Key of the grid cell that holds the point; never 0.
  std::uint64_t keyOf(const LevelPoints& points, std::size_t point) const;
  /// Forgets all cells; then up to `count` may come.
  void startTable(std::size_t count);
  /// Number of the cell with that key, in order of their coming; a new one is met at `point`.
  std::int32_t cellOf(std::uint64_t key, std::int32_t point);
  void thinUnclustered(const LevelPoints& points, const Segmentation& segmentation,
                       EvidenceCells& cells);
  void thinInstance(const LevelPoints& points, const std::int32_t* begin, const std::int32_t* end,
                    std::int32_t instance, EvidenceCells& cells);

  float inverseSize_;
  std::size_t maxCells_;
  /// Open addressing with 2^(64 - shift_) slots; key 0 marks a free one.
  std::vector<std::uint64_t> keys_;
  std::vector<std::int32_t> cellOfSlot_;
  int shift_ = 64;
  /// First point of each cell met so far.
  std::vector<std::int32_t> firstPoint_;
};

}  // namespace toss
