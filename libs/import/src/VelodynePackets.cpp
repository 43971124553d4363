// SPDX-License-Identifier: BSD-3-Clause
#include "VelodynePackets.h"

#include <algorithm>
#include <cstring>

namespace toss {
namespace {

using Scan = mrpt::obs::CObservationVelodyneScan;

std::uint16_t blockMark(const UdpPacket& packet, int block) {
  const std::uint8_t* at = packet.payload + block * Scan::SIZE_BLOCK;
  return static_cast<std::uint16_t>(at[0] | at[1] << 8);
}

}  // namespace

bool isVelodyneData(const UdpPacket& packet) {
  if (packet.size != Scan::PACKET_SIZE) return false;
  for (int block = 0; block < Scan::BLOCKS_PER_PACKET; ++block) {
    const std::uint16_t mark = blockMark(packet, block);
    if (mark != Scan::UPPER_BANK && mark != Scan::LOWER_BANK) return false;
  }
  return true;
}

bool isVelodynePosition(const UdpPacket& packet) {
  return packet.size == Scan::POS_PACKET_SIZE;
}

VelodyneRawPacket velodyneRawPacket(const UdpPacket& packet) {
  VelodyneRawPacket raw;
  static_assert(sizeof raw == Scan::PACKET_SIZE, "the packet's layout is that of the type");
  std::memcpy(static_cast<void*>(&raw), packet.payload, sizeof raw);
  return raw;
}

bool hasLowerBank(const VelodyneRawPacket& packet) {
  return std::any_of(std::begin(packet.blocks), std::end(packet.blocks),
                     [](const auto& block) { return block.header() == Scan::LOWER_BANK; });
}

std::string addressText(std::uint32_t address) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8)
    text += (text.empty() ? "" : ".") + std::to_string(address >> shift & 0xFFu);
  return text;
}

bool isFromSource(const UdpPacket& packet, const VelodyneImportOptions& options) {
  return options.source.empty() || addressText(packet.sourceAddress) == options.source;
}

bool isChosenData(const UdpPacket& packet, const VelodyneImportOptions& options) {
  return isFromSource(packet, options) &&
         (options.port == 0 || packet.destinationPort == options.port) && isVelodyneData(packet);
}

}  // namespace toss
