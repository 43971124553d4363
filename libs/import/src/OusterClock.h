// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/OusterFrames.h>

#include <cstdint>
#include <string>
#include <vector>

namespace toss {

/// From the clock of an Ouster sensor to UNIX time. A sensor that is synchronised (PTP, or a GPS)
/// sends UNIX time; one that is not counts from its start: what has to be added is then taken from
/// the capture's clock with the first frame, and anew where the counter falls back.
class OusterClock {
 public:
  /// Whether a time [s] is that of a counter: it lies before September 2001.
  static bool countsFromStart(double seconds) { return seconds < 1e9; }

  /// UNIX time [s] of a frame whose first column has the time `sensorTime` [ns, sensor's clock].
  double unixTime(const OusterFrame& frame, std::uint64_t sensorTime);

  /// What was done, and what is odd: plain sentences.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void anchor(const OusterFrame& frame, std::uint64_t sensorTime);

  bool anchored_ = false;
  std::uint64_t lastSensorTime_ = 0;
  /// Added to the sensor's time [ns].
  std::int64_t offset_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace toss
