// SPDX-License-Identifier: BSD-3-Clause
#include "IpFragments.h"

#include <algorithm>
#include <cstdlib>

namespace toss {
namespace {

constexpr std::size_t kUnit = 8;
constexpr std::size_t kLargestPayload = 65535;
constexpr std::size_t kMostPending = 64;
/// RFC 791 and Linux: 15 to 30 s. LiDAR packets of one capture use up all identifications within a
/// minute.
constexpr std::int64_t kPatience = 15'000'000'000;

bool sameDatagram(const Ipv4Packet& a, const Ipv4Packet& b) {
  return a.identification == b.identification && a.source == b.source &&
         a.destination == b.destination && a.protocol == b.protocol;
}

}  // namespace

bool parseIpv4(Bytes datagram, Ipv4Packet& packet) {
  const std::size_t header = 4u * (datagram.data[0] & 0x0Fu);
  // Where the network card cuts large datagrams up, the length is still 0 when they are captured.
  const std::size_t told = networkUint16(datagram.data + 2);
  const std::size_t length = told == 0 ? datagram.size : told;
  if (header < 20 || length < header || length > datagram.size) return false;
  const std::uint16_t place = networkUint16(datagram.data + 6);
  packet.identification = networkUint16(datagram.data + 4);
  packet.moreFragments = (place & 0x2000u) != 0;
  packet.offset = kUnit * (place & 0x1FFFu);
  packet.protocol = datagram.data[9];
  packet.source = networkUint32(datagram.data + 12);
  packet.destination = networkUint32(datagram.data + 16);
  packet.payload = {datagram.data + header, length - header};
  return true;
}

IpFragments::Pendings::iterator IpFragments::find(const Ipv4Packet& fragment, std::int64_t time) {
  const auto found = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& pending) {
    return sameDatagram(pending.key, fragment);
  });
  if (found != pending_.end()) return found;
  if (pending_.size() == kMostPending) {
    pending_.pop_front();
    ++lost_;
  }
  pending_.emplace_back();
  pending_.back().key = fragment;
  pending_.back().started = time;
  return std::prev(pending_.end());
}

void IpFragments::giveUpOld(std::int64_t time) {
  const auto size = pending_.size();
  // Clocks that are set back make it as old as ones that ran on.
  pending_.remove_if(
      [&](const Pending& pending) { return std::abs(time - pending.started) > kPatience; });
  lost_ += size - pending_.size();
}

Bytes IpFragments::add(const Ipv4Packet& fragment, std::int64_t time) {
  giveUpOld(time);
  const auto pending = find(fragment, time);
  const std::size_t end = fragment.offset + fragment.payload.size;
  const bool ragged = fragment.moreFragments && fragment.payload.size % kUnit != 0;
  const bool contradicts =
      pending->total != 0 &&
      (end > pending->total || (!fragment.moreFragments && end != pending->total));
  const bool afterEnd = !fragment.moreFragments && pending->bytes.size() > end;
  if (ragged || contradicts || afterEnd || end > kLargestPayload || fragment.payload.size == 0) {
    pending_.erase(pending);
    ++lost_;
    return {};
  }
  if (pending->bytes.size() < end) pending->bytes.resize(end);
  std::copy_n(fragment.payload.data, fragment.payload.size,
              pending->bytes.begin() + static_cast<std::ptrdiff_t>(fragment.offset));
  for (std::size_t unit = fragment.offset / kUnit; unit * kUnit < end; ++unit)
    pending->come.set(unit);
  if (!fragment.moreFragments) pending->total = end;
  const bool whole =
      pending->total != 0 && pending->come.count() == (pending->total + kUnit - 1) / kUnit;
  if (!whole) return {};
  complete_.swap(pending->bytes);
  pending_.erase(pending);
  return {complete_.data(), complete_.size()};
}

}  // namespace toss
