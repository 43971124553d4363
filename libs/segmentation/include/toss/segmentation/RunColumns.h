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

  /// Places of two columns in the table, the same in each row.
  struct Steps {
    std::size_t left, right;
  };

  /// `columns`: of the range image.
  void build(const RowRuns& runs, std::int32_t columns);

  Steps stepsOf(std::int32_t left, std::int32_t right) const {
    return {stepOf(left), stepOf(right)};
  }
  /// All runs of `row` that touch the columns between two, and a few beside them. Columns beyond
  /// either end of the row hold none.
  Span touching(int row, const Steps& columns) const {
    const std::size_t rowBegin = static_cast<std::size_t>(row) * steps_;
    return {endingBefore_[rowBegin + columns.left], beginningIn_[rowBegin + columns.right]};
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
