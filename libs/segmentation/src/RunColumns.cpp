// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RunColumns.h>

#include <algorithm>

namespace toss {

void RunColumns::build(const RowRuns& runs, std::int32_t columns) {
  columns_ = std::max(1, columns);
  steps_ = stepOf(columns_ - 1) + 2;
  const std::size_t rows = runs.rowBegin.size() - 1;
  endingBefore_.assign(rows * steps_, 0), beginningIn_.assign(rows * steps_, 0);
  for (std::size_t row = 0; row < rows; ++row) {
    std::int32_t* const endingBefore = endingBefore_.data() + row * steps_;
    std::int32_t* const beginningIn = beginningIn_.data() + row * steps_;
    for (std::int32_t run = runs.rowBegin[row]; run < runs.rowBegin[row + 1]; ++run) {
      ++endingBefore[stepOf(runs[run].lastColumn) + 1];
      ++beginningIn[stepOf(runs[run].firstColumn)];
    }
    std::int32_t ended = runs.rowBegin[row], begun = runs.rowBegin[row];
    for (std::size_t step = 0; step < steps_; ++step) {
      endingBefore[step] = ended += endingBefore[step];
      beginningIn[step] = begun += beginningIn[step];
    }
  }
}

}  // namespace toss
