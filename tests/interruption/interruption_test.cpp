// SPDX-License-Identifier: BSD-3-Clause
#include <Interruption.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace toss {
namespace {

// Signals change the process that they come to: each test sends them in one of its own.
constexpr int kCleared = 7;

[[noreturn]] void leaveWhereInterrupted(const InterruptionGuard& guard) {
  try {
    guard.check();
  } catch (const Interrupted&) {
    std::exit(kCleared);
  }
  std::exit(0);
}

TEST(Interruption, NoSignalIsNone) {
  EXPECT_EXIT(leaveWhereInterrupted({}), testing::ExitedWithCode(0), "");
}

TEST(Interruption, AnEarlySecondSignalIsACopyOfTheFirst) {
  for (const int second : {SIGTERM, SIGINT})
    EXPECT_EXIT(
        {
          const InterruptionGuard guard;
          std::raise(SIGTERM);
          std::raise(second);
          leaveWhereInterrupted(guard);
        },
        testing::ExitedWithCode(kCleared), "");
}

TEST(Interruption, ACopyThatComesAfterTheGuardIsGoneDoesNotEndTheProgram) {
  EXPECT_EXIT(
      {
        {
          const InterruptionGuard guard;
          std::raise(SIGINT);
        }
        std::raise(SIGINT);
        leaveWhereInterrupted({});
      },
      testing::ExitedWithCode(kCleared), "");
}

TEST(Interruption, ALaterSecondSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        const InterruptionGuard guard;
        std::raise(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        std::raise(SIGINT);
        leaveWhereInterrupted(guard);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(Interruption, WithoutAGuardTheFirstSignalEndsTheProgram) {
  EXPECT_EXIT(
      {
        { const InterruptionGuard guard; }
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace toss
