// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RunKeys.h>

namespace toss {

void RunKeys::build(const RowRuns& runs) {
  const std::size_t n = runs.size(), padded = n + static_cast<std::size_t>(kLanes);
  for (auto* keys : {&nearest_, &farthest_, &firstColumn_, &lastColumn_, &set_}) {
    keys->resize(padded);
  }
  const float hair = withHair(0.0f);
  for (std::size_t i = 0; i < n; ++i) {
    const Run& run = runs.runs[i];
    nearest_[i] = ofRange(run.measure.nearest - hair);
    farthest_[i] = ofRange(run.farthest + hair);
    firstColumn_[i] = ofColumn(run.firstColumn);
    lastColumn_[i] = ofColumn(run.lastColumn);
    setSet(static_cast<std::int32_t>(i), static_cast<std::int32_t>(i));
  }
}

}  // namespace toss
