// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

namespace toss {

/// The user has asked the program to stop.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// While one lives, the first SIGINT or SIGTERM does not end the program, so that unfinished
/// outputs are cleared away; one that comes more than half a second later does. Those in between
/// are copies of the first: programs that stop others (timeout, supervisors) send it twice.
class InterruptionGuard {
 public:
  InterruptionGuard();
  ~InterruptionGuard();
  InterruptionGuard(const InterruptionGuard&) = delete;
  InterruptionGuard& operator=(const InterruptionGuard&) = delete;

  /// Throws Interrupted once a signal has come.
  void check() const;
};

}  // namespace toss
