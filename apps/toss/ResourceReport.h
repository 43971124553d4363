// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>

namespace toss {

/// Measures what a run takes, from its construction on.
class ResourceReport {
 public:
  /// `threads`: those that the run may use.
  explicit ResourceReport(int threads) : threads_(threads) {}

  /// Writes resources.json: threads, processor, wall and processor time [s], scans per second and
  /// the most memory that the process has held [bytes]. Differs from run to run; what does not is
  /// in summary.json. Throws UserError where it can not be written.
  void write(const std::filesystem::path& file, std::uint64_t scans) const;

 private:
  using Clock = std::chrono::steady_clock;
  int threads_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace toss
