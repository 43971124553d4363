// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RunKeys.h>

namespace toss {

void RunKeys::build(const RowRuns& runs) {
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  for (auto* keys : {&nearest_, &farthest_, &firstColumn_, &lastColumn_, &set_}) {
    keys->resize(padded);
  }
  const float hair = withHair(0.0f);
  for (std::size_t run = 0; run < n; ++run) {
    nearest_[run] = ofRange(runs.nearest[run] - hair);
    farthest_[run] = ofRange(runs.farthest[run] + hair);
    firstColumn_[run] = ofColumn(runs.firstColumn[run]);
    lastColumn_[run] = ofColumn(runs.lastColumn[run]);
    setSet(static_cast<std::int32_t>(run), static_cast<std::int32_t>(run));
  }
}

}  // namespace toss
