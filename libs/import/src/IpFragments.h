// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>
#include <list>
#include <vector>

#include "LinkLayer.h"

namespace toss {

/// The header of an IPv4 datagram or fragment, and what it carries (RFC 791).
struct Ipv4Packet {
  std::uint32_t source = 0, destination = 0;
  std::uint16_t identification = 0;
  std::uint8_t protocol = 0;
  /// Place of the payload in the whole datagram [bytes]; whether more fragments follow.
  std::size_t offset = 0;
  bool moreFragments = false;
  Bytes payload;

  bool isFragment() const { return offset > 0 || moreFragments; }
};

/// Reads the header; false where lengths contradict each other or bytes are missing.
bool parseIpv4(Bytes datagram, Ipv4Packet& packet);

/// Puts IPv4 fragments together (RFC 815), whatever their order; a bounded number of datagrams at
/// a time.
class IpFragments {
 public:
  /// Takes a fragment that came at `time` [ns]. Returns the whole payload with its last missing
  /// fragment, no data before; valid until the next call.
  Bytes add(const Ipv4Packet& fragment, std::int64_t time);
  /// Datagrams given up because fragments did not come in time or contradicted each other.
  std::uint64_t lost() const { return lost_; }
  /// Datagrams that still wait for fragments.
  std::size_t waiting() const { return pending_.size(); }

 private:
  struct Pending {
    Ipv4Packet key;
    std::int64_t started = 0;
    std::vector<std::uint8_t> bytes;
    /// Units of 8 bytes that have come.
    std::bitset<8192> come;
    /// Length of the whole payload; 0 until the last fragment has come.
    std::size_t total = 0;
  };
  using Pendings = std::list<Pending>;

  Pendings::iterator find(const Ipv4Packet& fragment, std::int64_t time);
  void giveUpOld(std::int64_t time);

  Pendings pending_;
  std::vector<std::uint8_t> complete_;
  std::uint64_t lost_ = 0;
};

}  // namespace toss
