// SPDX-License-Identifier: BSD-3-Clause
// From a captured frame to the IPv4 datagram in it (IEEE 802.3, 802.1Q; the LINKTYPE_ pages of
// tcpdump.org).
#include "LinkLayer.h"

#include <pcap/dlt.h>

namespace toss {
namespace {

constexpr std::uint16_t kIpv4 = 0x0800;
#ifdef DLT_LINUX_SLL2
constexpr int kLinuxCooked2 = DLT_LINUX_SLL2;
#else
constexpr int kLinuxCooked2 = 276;
#endif

bool isVlanTag(std::uint16_t type) {
  return type == 0x8100 || type == 0x88A8 || type == 0x9100;
}

/// What follows an EtherType that stands at `offset`, VLAN tags passed over.
Bytes afterEtherType(Bytes frame, std::size_t offset) {
  while (frame.size >= offset + 2) {
    const std::uint16_t type = networkUint16(frame.data + offset);
    if (type == kIpv4) return frame.from(offset + 2);
    if (!isVlanTag(type)) return {};
    offset += 4;
  }
  return {};
}

Bytes afterLoopbackFamily(Bytes frame) {
  // AF_INET is 2 everywhere; the byte order is that of the capturing computer or the network's.
  if (frame.size < 4) return {};
  const std::uint32_t family = networkUint32(frame.data);
  return family == 2u || family == 0x02000000u ? frame.from(4) : Bytes{};
}

Bytes afterCookedHeader2(Bytes frame) {
  return frame.size >= 20 && networkUint16(frame.data) == kIpv4 ? frame.from(20) : Bytes{};
}

}  // namespace

bool knowsLink(int link) {
  return link == DLT_EN10MB || link == DLT_LINUX_SLL || link == kLinuxCooked2 || link == DLT_RAW ||
         link == DLT_IPV4 || link == DLT_NULL || link == DLT_LOOP;
}

Bytes ipv4Datagram(Bytes frame, int link) {
  Bytes datagram = frame;
  if (link == DLT_EN10MB) datagram = afterEtherType(frame, 12);
  if (link == DLT_LINUX_SLL) datagram = afterEtherType(frame, 14);
  if (link == kLinuxCooked2) datagram = afterCookedHeader2(frame);
  if (link == DLT_NULL || link == DLT_LOOP) datagram = afterLoopbackFamily(frame);
  const bool versionFits = datagram.size >= 20 && datagram.data[0] >> 4 == 4;
  return versionFits ? datagram : Bytes{};
}

}  // namespace toss
