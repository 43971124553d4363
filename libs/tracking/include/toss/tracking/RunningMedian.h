// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

namespace toss {

/// Exact median of all values added so far: the upper one of an even number of values.
class RunningMedian {
 public:
  void add(double value) {
    const auto single = static_cast<float>(value);
    sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), single), single);
  }

  /// 0 without values.
  double value() const {
    return sorted_.empty() ? 0.0 : static_cast<double>(sorted_[sorted_.size() / 2]);
  }

 private:
  std::vector<float> sorted_;
};

}  // namespace toss
