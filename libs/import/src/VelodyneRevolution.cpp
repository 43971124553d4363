// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneRevolution.h"

#include <algorithm>
#include <utility>

namespace toss {
namespace {

/// Of the sensor's clock, which begins anew each hour [us].
constexpr std::int64_t kHour = 3'600'000'000;
/// The slowest sensors turn five times per second; what is longer is a pause, or a rotor that
/// stands still.
constexpr std::int64_t kLongestRevolution = 500'000;

/// Time from a to b by the sensor's clock, from minus to plus half an hour [us].
std::int64_t elapsed(const TimedPacket& a, const TimedPacket& b) {
  const std::int64_t difference =
      static_cast<std::int64_t>(b.raw.gps_timestamp()) - a.raw.gps_timestamp();
  if (difference > kHour / 2) return difference - kHour;
  return difference < -kHour / 2 ? difference + kHour : difference;
}

}  // namespace

bool VelodyneRevolution::begins(const TimedPacket& packet) const {
  if (packets_.empty()) return false;
  return packet.raw.blocks[0].rotation() < packets_.back().raw.blocks[0].rotation() ||
         elapsed(packets_.front(), packet) > kLongestRevolution;
}

std::optional<std::vector<TimedPacket>> VelodyneRevolution::add(const TimedPacket& packet) {
  std::optional<std::vector<TimedPacket>> done;
  const auto isLaterThan = [&](const TimedPacket& other) { return elapsed(other, packet) >= 0; };
  // The clock jumps back where the receiver sets it: that is no late packet.
  const bool late = !packets_.empty() && !isLaterThan(packets_.back()) &&
                    elapsed(packet, packets_.back()) < kLongestRevolution;
  if (late) {
    const auto place = std::find_if(packets_.rbegin(), packets_.rend(), isLaterThan);
    packets_.insert(place.base(), packet);
    return done;
  }
  const bool clockJumpsBack = !packets_.empty() && !isLaterThan(packets_.back());
  if (clockJumpsBack || begins(packet)) done = rest();
  packets_.push_back(packet);
  return done;
}

std::vector<TimedPacket> VelodyneRevolution::rest() {
  return std::exchange(packets_, {});
}

}  // namespace toss
