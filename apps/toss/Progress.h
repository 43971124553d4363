// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "Interruption.h"

namespace toss {

/// Tells on stderr how far a long run is: a line that renews itself on a terminal, one line every
/// 10 % elsewhere; nothing in the first second.
class Progress {
 public:
  /// `what` is done, counted in `unit` ("scans").
  Progress(std::string what, std::string unit, bool quiet);
  ~Progress();

  /// `done` units are done, which is the share `fraction` (0 to 1) of all. Throws Interrupted where
  /// the user has asked for it.
  void update(std::uint64_t done, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(std::uint64_t done, double fraction, double seconds) const;

  InterruptionGuard interruption_;
  std::string what_, unit_;
  bool quiet_, terminal_, shown_ = false;
  int lastTenth_ = 0;
  Clock::time_point start_, lastShown_;
};

}  // namespace toss
