// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Counts scans, each at most once: the paper's f is 1 if any box of a scan is near.
class ScanTally {
 public:
  /// Starts a new count.
  void start() {
    if (++round_ == 0) {
      lastRound_.assign(lastRound_.size(), 0);
      round_ = 1;
    }
    count_ = 0;
  }
  void add(std::int32_t scan) {
    const auto place = static_cast<std::size_t>(scan);
    if (place >= lastRound_.size()) lastRound_.resize(place + 1 + place / 2, 0);
    if (lastRound_[place] == round_) return;
    lastRound_[place] = round_;
    ++count_;
  }
  bool has(std::int32_t scan) const {
    const auto place = static_cast<std::size_t>(scan);
    return place < lastRound_.size() && lastRound_[place] == round_;
  }
  int count() const { return count_; }

 private:
  std::vector<std::uint32_t> lastRound_;
  std::uint32_t round_ = 0;
  int count_ = 0;
};

}  // namespace toss
