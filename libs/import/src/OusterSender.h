// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/UdpPackets.h>

#include <cstdint>
#include <filesystem>

#include "OusterPacketFormat.h"

namespace toss {

/// Which packets of a capture are those of one sensor.
struct OusterSender {
  std::uint32_t address = 0;
  std::uint16_t port = 0;
  /// 0 in the legacy profile.
  std::uint64_t serialNumber = 0;
  /// Whether its packets carry check sums: firmware before 3 sends other bytes in their place.
  bool checkSums = false;

  /// Whether it sent the packet; serial numbers are left out of account.
  bool sent(const UdpPacket& packet) const {
    return packet.sourceAddress == address && packet.destinationPort == port;
  }
};

/// Looks through the first packets for the sensor that the metadata are of: by serial number, else
/// port, else the first whose packets have the right size. Throws UserError where there is none,
/// telling what there is instead.
OusterSender findOusterSender(const std::filesystem::path& capture, const OusterMetadata& metadata,
                              const OusterPacketFormat& format);

}  // namespace toss
