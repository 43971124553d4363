// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationGPS.h>
#include <toss/import/UdpPackets.h>

#include <cstdint>
#include <optional>
#include <string>

namespace toss {

/// What a position packet of a Velodyne sensor says.
struct VelodynePosition {
  /// The sensor's clock: time since the full hour [us].
  std::uint32_t microseconds = 0;
  /// The receiver's sentence.
  mrpt::obs::gnss::Message_NMEA_RMC sentence;
  /// UNIX time of the sentence [s].
  double time = 0.0;
  /// Whether the receiver vouches for it.
  bool valid() const { return sentence.fields.validity_char == 'A'; }
};

/// Reads a position packet; nothing where it holds no whole $GPRMC sentence with a right checksum.
std::optional<VelodynePosition> readVelodynePosition(const UdpPacket& packet);

/// A $..RMC sentence (NMEA 0183), up to its checksum; nothing where it is none.
std::optional<mrpt::obs::gnss::Message_NMEA_RMC> readRmc(const std::string& sentence);

}  // namespace toss
