// SPDX-License-Identifier: BSD-3-Clause
#include "OusterClock.h"

#include <cstdio>
#include <cstdlib>

namespace toss {
namespace {

/// Clocks that differ by more were set by different references.
constexpr std::int64_t kSameClock = 1'000'000'000;

bool isCounter(std::uint64_t nanoseconds) {
  return OusterClock::countsFromStart(1e-9 * static_cast<double>(nanoseconds));
}

}  // namespace

double OusterClock::unixTime(const OusterFrame& frame, std::uint64_t sensorTime) {
  if (!anchored_ || (isCounter(sensorTime) && sensorTime < lastSensorTime_))
    anchor(frame, sensorTime);
  lastSensorTime_ = sensorTime;
  return 1e-9 * static_cast<double>(static_cast<std::int64_t>(sensorTime) + offset_);
}

void OusterClock::anchor(const OusterFrame& frame, std::uint64_t sensorTime) {
  const bool again = anchored_;
  anchored_ = true;
  const std::int64_t difference =
      frame.captureTime - static_cast<std::int64_t>(frame.captureTimestamp);
  if (isCounter(sensorTime)) {
    offset_ = difference;
    notes_.push_back(again ? "the sensor's counter fell back, time stamps go on by the capture's "
                             "clock"
                           : "the sensor counts time from its start (no PTP); time stamps were "
                             "moved to UNIX time by the capture's clock");
    return;
  }
  offset_ = 0;
  if (std::abs(difference) <= kSameClock) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "the sensor's clock is %.1f s behind the capture's; time stamps are the sensor's, "
                "poses must be too",
                1e-9 * static_cast<double>(difference));
  notes_.emplace_back(text);
}

}  // namespace toss
