// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace toss {

Progress::Progress(std::string what, std::string unit, bool quiet)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      lastShown_(start_) {}

Progress::~Progress() {
  if (terminal_ && shown_) std::cerr << "\n";
}

std::string Progress::line(std::uint64_t done, double fraction, double seconds) const {
  char text[160];
  const double left = fraction > 0.0 ? seconds * (1.0 - fraction) / fraction : 0.0;
  std::snprintf(text, sizeof(text), "%s: %3.0f %%, %llu %s, %.1f %s/s, %.0f s left", what_.c_str(),
                100.0 * fraction, static_cast<unsigned long long>(done), unit_.c_str(),
                static_cast<double>(done) / seconds, unit_.c_str(), left);
  return text;
}

void Progress::update(std::uint64_t done, double fraction) {
  interruption_.check();
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (seconds < 1.0) return;
  if (terminal_) {
    if (now - lastShown_ < std::chrono::milliseconds(200)) return;
    lastShown_ = now;
    std::cerr << "\r" << line(done, fraction, seconds) << "   " << std::flush;
    shown_ = true;
  } else if (const int tenth = static_cast<int>(10.0 * fraction + 1e-9); tenth > lastTenth_) {
    lastTenth_ = tenth;
    std::cerr << line(done, fraction, seconds) << "\n";
  }
}

}  // namespace toss
