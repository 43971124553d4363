// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace toss {

/// Measures the stages of one scan one after another [ms].
class StageClock {
 public:
  using Times = std::vector<std::pair<std::string, double>>;

  void restart() {
    times_.clear();
    last_ = Clock::now();
  }
  /// Books the time since the last call on `stage`.
  void lap(const char* stage) {
    const Clock::time_point now = Clock::now();
    book(stage, std::chrono::duration<double, std::milli>(now - last_).count());
    last_ = now;
  }
  /// Books `milliseconds` that were measured elsewhere; a stage may come in several parts.
  void book(const char* stage, double milliseconds) {
    for (auto& [name, time] : times_)
      if (name == stage) {
        time += milliseconds;
        return;
      }
    times_.emplace_back(stage, milliseconds);
  }
  const Times& times() const { return times_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_;
  Times times_;
};

}  // namespace toss
