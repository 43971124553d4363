// SPDX-License-Identifier: BSD-3-Clause
#include "OusterSender.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace toss {
namespace {

/// Packets in which a sensor must show itself: several revolutions of two sensors.
constexpr std::uint64_t kPacketsLookedAt = 2048;

struct Found {
  std::vector<OusterSender> senders;
  /// Datagrams by port and size, for the message where nothing fits.
  std::map<std::pair<std::uint16_t, std::size_t>, std::uint64_t> sizes;
};

OusterSender& senderOf(const UdpPacket& packet, std::uint64_t serialNumber, Found& found) {
  for (OusterSender& sender : found.senders)
    if (sender.sent(packet) && sender.serialNumber == serialNumber) return sender;
  found.senders.push_back({packet.sourceAddress, packet.destinationPort, serialNumber, false});
  return found.senders.back();
}

Found lookThrough(UdpPacketReader& reader, const OusterPacketFormat& format) {
  Found found;
  UdpPacket packet;
  // Of a capture without any packet that fits all is looked through.
  for (std::uint64_t fitting = 0; fitting < kPacketsLookedAt && reader.next(packet);) {
    ++found.sizes[{packet.destinationPort, packet.size}];
    if (packet.size != format.packetSize()) continue;
    ++fitting;
    OusterSender& sender = senderOf(packet, format.serialNumber(packet.payload), found);
    sender.checkSums = sender.checkSums || format.checkSumFits(packet.payload);
  }
  return found;
}

[[noreturn]] void failWithoutPackets(const std::filesystem::path& capture,
                                     const OusterMetadata& metadata,
                                     const OusterPacketFormat& format, const Found& found) {
  const auto most =
      std::max_element(found.sizes.begin(), found.sizes.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::string instead = most == found.sizes.end()
                                  ? ", nor any other UDP packet"
                                  : ", but " + std::to_string(most->second) + " of " +
                                        std::to_string(most->first.second) + " bytes to port " +
                                        std::to_string(most->first.first);
  throw UserError(capture.string(),
                  "holds no packets of " + std::to_string(format.packetSize()) +
                      " bytes, as the metadata tell (" + nameOf(metadata.profile) + ", " +
                      std::to_string(metadata.pixelsPerColumn) + " beams)" + instead,
                  "give the metadata that were saved with this capture");
}

}  // namespace

OusterSender findOusterSender(const std::filesystem::path& capture, const OusterMetadata& metadata,
                              const OusterPacketFormat& format) {
  UdpPacketReader reader(capture);
  const Found found = lookThrough(reader, format);
  if (found.senders.empty()) failWithoutPackets(capture, metadata, format, found);
  const auto first = [&](auto fits) {
    return std::find_if(found.senders.begin(), found.senders.end(), fits);
  };
  const auto end = found.senders.end();
  // The sensor's number decides where both know it: other packets are another sensor's.
  const auto same = first([&](const OusterSender& sender) {
    return sender.serialNumber != 0 && sender.serialNumber == metadata.serialNumber;
  });
  if (same != end) return *same;
  const bool allNumbered = metadata.serialNumber != 0 &&
                           first([](const OusterSender& s) { return s.serialNumber == 0; }) == end;
  if (allNumbered)
    throw UserError(capture.string(),
                    "holds packets of sensor " + std::to_string(found.senders[0].serialNumber) +
                        ", but the metadata are those of sensor " +
                        std::to_string(metadata.serialNumber),
                    "give the metadata that were saved with this capture");
  const auto onPort = first([&](const OusterSender& s) { return s.port == metadata.lidarPort; });
  return onPort != end ? *onPort : found.senders.front();
}

}  // namespace toss
