// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/import/OusterMetadata.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace toss {

/// Where things stand in the packets of a profile (Ouster's firmware user manual, "Lidar Data
/// Format"). All numbers are little-endian. The members that take a packet or column read it
/// without a check: its size must be packetSize().
class OusterPacketFormat {
 public:
  /// Throws UserError where the metadata would make packets larger than UDP carries.
  explicit OusterPacketFormat(const OusterMetadata& metadata);

  std::size_t packetSize() const { return packetSize_; }
  /// Returns per pixel: 1 or 2.
  std::size_t returns() const { return returns_; }

  std::uint16_t frameId(const std::uint8_t* packet) const;
  /// Serial number and number of the sensor's start; 0 in the legacy profile.
  std::uint64_t serialNumber(const std::uint8_t* packet) const;
  std::uint32_t initializationId(const std::uint8_t* packet) const;
  /// Whether the packet's last 8 bytes are the check sum of the others. Never in the legacy
  /// profile, whose packets have none.
  bool checkSumFits(const std::uint8_t* packet) const;

  const std::uint8_t* column(const std::uint8_t* packet, int number) const {
    return packet + headerSize_ + static_cast<std::size_t>(number) * columnSize_;
  }
  /// Time of a column [ns], by the sensor's clock.
  static std::uint64_t timestamp(const std::uint8_t* column);
  /// Number of the column in the revolution.
  static std::uint16_t measurementId(const std::uint8_t* column);
  /// Status bits as they are sent, and whether they mean that the column was measured.
  std::uint32_t status(const std::uint8_t* column) const;
  bool valid(std::uint32_t status) const;

  /// Range [mm] (0 = no return) and reflectivity of a pixel; `which`: 0 the first return, 1 the
  /// second.
  std::uint32_t range(const std::uint8_t* column, int pixel, std::size_t which) const;
  std::uint16_t reflectivity(const std::uint8_t* column, int pixel, std::size_t which) const;

 private:
  /// Bytes at a place in the pixel, those of `mask`, moved up by `shift` bits.
  struct Field {
    std::size_t offset, bytes;
    std::uint32_t mask;
    int shift;
  };
  struct Return {
    Field range, reflectivity;
  };
  struct Layout {
    std::size_t pixelSize, returns;
    std::array<Return, 2> fields;
  };

  static const Layout& layoutOf(OusterProfile profile);
  std::uint32_t read(const std::uint8_t* column, int pixel, const Field& field) const;

  bool legacy_;
  Layout layout_;
  std::size_t returns_, headerSize_, columnHeaderSize_, columnSize_, packetSize_;
};

}  // namespace toss
