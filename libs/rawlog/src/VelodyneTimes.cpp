// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneTimes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace toss {
namespace {

/// The sensor's clock begins anew each hour [us].
constexpr std::int64_t kHour = 3'600'000'000;

/// MRPT calculates time stamps with doubles that begin in 1601: a few microseconds get lost.
constexpr std::int64_t kRounding = 20;

/// From minus to plus half a turn [0.01 degrees].
float wrapped(float angle) {
  constexpr float kTurn = 36000.0f;
  return angle - kTurn * std::round(angle / kTurn);
}

float median(std::vector<float> values) {
  if (values.empty()) return 0.0f;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

VelodyneTimes::VelodyneTimes(const mrpt::obs::CObservationVelodyneScan& scan) {
  for (const auto& raw : scan.scan_packets) {
    const std::int64_t first = scan.scan_packets[0].gps_timestamp(), now = raw.gps_timestamp();
    packets_.push_back({now >= first ? now - first : kHour + now - first,
                        static_cast<float>(raw.blocks[0].rotation())});
  }
  std::vector<float> durations, turns;
  for (std::size_t i = 1; i < packets_.size(); ++i) {
    durations.push_back(static_cast<float>(packets_[i].time - packets_[i - 1].time));
    turns.push_back(wrapped(packets_[i].azimuth - packets_[i - 1].azimuth));
  }
  duration_ = median(std::move(durations));
  turn_ = median(std::move(turns));
}

float VelodyneTimes::timeOf(std::int64_t packetTime, float azimuth) {
  const auto isCurrent = [&] {
    return std::abs(packets_[current_].time - packetTime) <= kRounding;
  };
  for (std::size_t tried = 0; !isCurrent() && tried < packets_.size(); ++tried)
    current_ = (current_ + 1) % packets_.size();
  std::int64_t start = isCurrent() ? packets_[current_].time : packetTime;
  // MRPT takes a packet that was sent before the first one for one of the next hour.
  if (start > kHour / 2) start -= kHour;
  float within = 0.0f;
  if (turn_ > 0.0f && isCurrent())
    within = std::clamp(wrapped(azimuth - packets_[current_].azimuth) / turn_, 0.0f, 1.0f);
  const double microseconds =
      static_cast<double>(start) + static_cast<double>(within) * static_cast<double>(duration_);
  return static_cast<float>(1e-6 * microseconds);
}

}  // namespace toss
