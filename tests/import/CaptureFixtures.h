// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Captures of network traffic for tests, made byte by byte.
namespace toss::test {

inline std::string networkBytes(std::uint64_t value, int count) {
  std::string bytes;
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(value >> (8 * i) & 0xFFu);
  return bytes;
}

inline std::string littleBytes(std::uint64_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFu);
  return bytes;
}

/// Ports and payload of a UDP datagram.
inline std::string udpOf(const std::string& payload, std::uint16_t destinationPort = 7502) {
  return networkBytes(7502, 2) + networkBytes(destinationPort, 2) +
         networkBytes(payload.size() + 8, 2) + networkBytes(0, 2) + payload;
}

/// An IPv4 datagram, or the fragment of one that begins at `offset` [bytes].
inline std::string ipv4Of(const std::string& payload, std::uint16_t identification = 1,
                          std::size_t offset = 0, bool more = false, std::uint8_t protocol = 17) {
  return networkBytes(0x45, 1) + networkBytes(0, 1) + networkBytes(payload.size() + 20, 2) +
         networkBytes(identification, 2) + networkBytes((more ? 0x2000u : 0u) | offset / 8, 2) +
         networkBytes(64, 1) + networkBytes(protocol, 1) + networkBytes(0, 2) +
         networkBytes(0xC0000201, 4) + networkBytes(0xC0000202, 4) + payload;
}

inline std::string ethernetOf(const std::string& datagram) {
  return std::string(12, '\x02') + networkBytes(0x0800, 2) + datagram;
}

/// A capture file of frames one millisecond apart; `link` is tcpdump.org's LINKTYPE_ number.
inline std::string pcapOf(const std::vector<std::string>& frames, std::uint32_t link = 1) {
  std::string file = littleBytes(0xA1B2C3D4, 4) + littleBytes(2, 2) + littleBytes(4, 2) +
                     littleBytes(0, 8) + littleBytes(65535, 4) + littleBytes(link, 4);
  for (std::size_t i = 0; i < frames.size(); ++i)
    file += littleBytes(1'600'000'000, 4) + littleBytes(1000 * i, 4) +
            littleBytes(frames[i].size(), 4) + littleBytes(frames[i].size(), 4) + frames[i];
  return file;
}

/// The same as pcapng, with time stamps in microseconds.
inline std::string pcapngOf(const std::vector<std::string>& frames, std::uint16_t link = 1) {
  const auto block = [](std::uint32_t type, std::string body) {
    body.resize((body.size() + 3) / 4 * 4);
    const std::string length = littleBytes(body.size() + 12, 4);
    return littleBytes(type, 4) + length + body + length;
  };
  std::string file = block(0x0A0D0D0A, littleBytes(0x1A2B3C4D, 4) + littleBytes(1, 2) +
                                           littleBytes(0, 2) + std::string(8, '\xFF'));
  file += block(1, littleBytes(link, 2) + littleBytes(0, 2) + littleBytes(0, 4));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::uint64_t time = 1'600'000'000'000'000 + 1000 * i;
    file += block(6, littleBytes(0, 4) + littleBytes(time >> 32, 4) + littleBytes(time, 4) +
                         littleBytes(frames[i].size(), 4) + littleBytes(frames[i].size(), 4) +
                         frames[i]);
  }
  return file;
}

}  // namespace toss::test
