// SPDX-License-Identifier: BSD-3-Clause
#include "Interruption.h"

#include <csignal>

namespace toss {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note(int) {
  interrupted = 1;
}

constexpr int kSignals[] = {SIGINT, SIGTERM};

}  // namespace

InterruptionGuard::InterruptionGuard() {
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int number : kSignals) sigaction(number, &action, nullptr);
}

InterruptionGuard::~InterruptionGuard() {
  for (const int number : kSignals) std::signal(number, SIG_DFL);
}

void InterruptionGuard::check() const {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace toss
