// SPDX-License-Identifier: BSD-3-Clause
#include "Interruption.h"

#include <csignal>
#include <ctime>

namespace toss {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM};

/// Programs that stop others send the same signal to the process and to its group: copies [s].
constexpr double kCopies = 0.5;

volatile std::sig_atomic_t interrupted = 0;
timespec interruptedAt = {};

double secondsSinceInterruption() {
  timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - interruptedAt.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - interruptedAt.tv_nsec);
}

void note(int number) {
  if (interrupted == 0) {
    clock_gettime(CLOCK_MONOTONIC, &interruptedAt);
    interrupted = 1;
  } else if (secondsSinceInterruption() > kCopies) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

InterruptionGuard::InterruptionGuard() {
  struct sigaction action = {};
  action.sa_handler = note;
  for (const int number : kSignals) sigaddset(&action.sa_mask, number);
  for (const int number : kSignals) sigaction(number, &action, nullptr);
}

InterruptionGuard::~InterruptionGuard() {
  if (interrupted != 0) return;
  for (const int number : kSignals) std::signal(number, SIG_DFL);
}

void InterruptionGuard::check() const {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace toss
