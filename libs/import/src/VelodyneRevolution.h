// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "VelodynePackets.h"

namespace toss {

/// A data packet with the time of its capture [ns].
struct TimedPacket {
  VelodyneRawPacket raw;
  std::int64_t captureTime = 0;
};

/// Cuts the stream of data packets into revolutions: a new one begins with the packet whose first
/// azimuth is smaller than that of the packet before. Packets that come late are put where they
/// belong by the sensor's clock.
class VelodyneRevolution {
 public:
  /// Takes the next packet; gives the revolution that it ends, if it does.
  std::optional<std::vector<TimedPacket>> add(const TimedPacket& packet);
  /// The packets since the last cut.
  std::vector<TimedPacket> rest();

 private:
  bool begins(const TimedPacket& packet) const;

  std::vector<TimedPacket> packets_;
};

}  // namespace toss
