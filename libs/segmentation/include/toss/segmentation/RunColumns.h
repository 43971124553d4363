// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RowRuns.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Finds the runs that lie in given columns of a row by a table of every few columns. A walk along
/// the row would be mispredicted at nearly every step.
class RunColumns {
 public:
  /// Consecutive runs.
  struct Span {
    std::int32_t begin, end;
  };

  /// `columns`: of the range image.
  void build(const RowRuns& runs, std::int32_t columns);

  /// All runs of `row` that touch the columns left..right, and a few beside them. Columns beyond
  /// either end of the row hold none.
  Span touching(int row, std::int32_t left, std::int32_t right) const {
    const std::size_t rowBegin = static_cast<std::size_t>(row) * steps_;
    return {endingBefore_[rowBegin + stepOf(left)], beginningIn_[rowBegin + stepOf(right)]};
  }

 private:
  static constexpr std::size_t kColumnsPerStep = 4;

  std::size_t stepOf(std::int32_t column) const {
    const std::int32_t inside = column < 0 ? 0 : column >= columns_ ? columns_ - 1 : column;
    return static_cast<std::size_t>(inside) / kColumnsPerStep;
  }

  std::int32_t columns_ = 0;
  std::size_t steps_ = 0;
  /// For each row and step: its first run that ends there or later, and one past its last run that
  /// begins there or before, shape [rows, steps].
  std::vector<std::int32_t> endingBefore_, beginningIn_;
};

}  // namespace toss
