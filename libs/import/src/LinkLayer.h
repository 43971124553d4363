// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace toss {

/// Bytes of a frame, not owned.
struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;

  /// The bytes from `offset` on; none where there are fewer.
  Bytes from(std::size_t offset) const {
    return offset > size ? Bytes{} : Bytes{data + offset, size - offset};
  }
};

/// Whole numbers in network byte order.
inline std::uint16_t networkUint16(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
}
inline std::uint32_t networkUint32(const std::uint8_t* bytes) {
  return static_cast<std::uint32_t>(networkUint16(bytes)) << 16 | networkUint16(bytes + 2);
}

/// Whether frames of this kind of link (libpcap's DLT_ number) are understood.
bool knowsLink(int link);

/// The IPv4 datagram within a frame; no data where it holds something else.
Bytes ipv4Datagram(Bytes frame, int link);

}  // namespace toss
