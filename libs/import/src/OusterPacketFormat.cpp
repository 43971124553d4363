// SPDX-License-Identifier: BSD-3-Clause
#include "OusterPacketFormat.h"

#include <lzma.h>
#include <toss/geometry/Error.h>

#include <string>

namespace toss {
namespace {

constexpr std::size_t kLargestPacket = 65507;
constexpr std::size_t kCheckSumSize = 8;

std::uint64_t littleEndian(const std::uint8_t* bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= static_cast<std::uint64_t>(bytes[i]) << (8 * i);
  return value;
}

}  // namespace

const OusterPacketFormat::Layout& OusterPacketFormat::layoutOf(OusterProfile profile) {
  static const Layout legacy = {12, 1, {{{{0, 4, 0xFFFFF, 0}, {4, 2, 0xFFFF, 0}}, {}}}};
  static const Layout single = {12, 1, {{{{0, 4, 0x7FFFF, 0}, {4, 1, 0xFF, 0}}, {}}}};
  static const Layout dual = {
      16, 2, {{{{0, 4, 0x7FFFF, 0}, {3, 1, 0xFF, 0}}, {{4, 4, 0x7FFFF, 0}, {7, 1, 0xFF, 0}}}}};
  // Ranges are sent in units of 8 mm.
  static const Layout lowRate = {4, 1, {{{{0, 2, 0x7FFF, 3}, {2, 1, 0xFF, 0}}, {}}}};
  switch (profile) {
    case OusterProfile::Legacy:
      return legacy;
    case OusterProfile::Rng19Rfl8Sig16Nir16:
      return single;
    case OusterProfile::Rng19Rfl8Sig16Nir16Dual:
      return dual;
    case OusterProfile::Rng15Rfl8Nir8:
      return lowRate;
  }
  return legacy;
}

OusterPacketFormat::OusterPacketFormat(const OusterMetadata& metadata)
    : legacy_(metadata.profile == OusterProfile::Legacy),
      layout_(layoutOf(metadata.profile)),
      returns_(layout_.returns),
      headerSize_(legacy_ ? 0 : 32),
      columnHeaderSize_(legacy_ ? 16 : 12) {
  const std::size_t columnFooter = legacy_ ? 4 : 0, footer = legacy_ ? 0 : 32;
  columnSize_ = columnHeaderSize_ + columnFooter +
                static_cast<std::size_t>(metadata.pixelsPerColumn) * layout_.pixelSize;
  packetSize_ =
      headerSize_ + footer + static_cast<std::size_t>(metadata.columnsPerPacket) * columnSize_;
  if (packetSize_ > kLargestPacket)
    throw UserError(
        "the sensor's metadata",
        "tell of packets of " + std::to_string(packetSize_) + " bytes, more than a network carries",
        "check pixels_per_column and columns_per_packet");
}

std::uint16_t OusterPacketFormat::frameId(const std::uint8_t* packet) const {
  return static_cast<std::uint16_t>(littleEndian(packet + (legacy_ ? 10 : 2), 2));
}

std::uint64_t OusterPacketFormat::serialNumber(const std::uint8_t* packet) const {
  return legacy_ ? 0 : littleEndian(packet + 7, 5);
}

std::uint32_t OusterPacketFormat::initializationId(const std::uint8_t* packet) const {
  return legacy_ ? 0 : static_cast<std::uint32_t>(littleEndian(packet + 4, 3));
}

bool OusterPacketFormat::checkSumFits(const std::uint8_t* packet) const {
  if (legacy_) return false;
  const std::size_t covered = packetSize_ - kCheckSumSize;
  return lzma_crc64(packet, covered, 0) == littleEndian(packet + covered, kCheckSumSize);
}

std::uint64_t OusterPacketFormat::timestamp(const std::uint8_t* column) {
  return littleEndian(column, 8);
}

std::uint16_t OusterPacketFormat::measurementId(const std::uint8_t* column) {
  return static_cast<std::uint16_t>(littleEndian(column + 8, 2));
}

std::uint32_t OusterPacketFormat::status(const std::uint8_t* column) const {
  return static_cast<std::uint32_t>(legacy_ ? littleEndian(column + columnSize_ - 4, 4)
                                            : littleEndian(column + 10, 2));
}

bool OusterPacketFormat::valid(std::uint32_t status) const {
  return legacy_ ? status == 0xFFFFFFFFu : (status & 1u) != 0;
}

std::uint32_t OusterPacketFormat::read(const std::uint8_t* column, int pixel,
                                       const Field& field) const {
  const std::uint8_t* bytes =
      column + columnHeaderSize_ + static_cast<std::size_t>(pixel) * layout_.pixelSize;
  const auto value = static_cast<std::uint32_t>(littleEndian(bytes + field.offset, field.bytes));
  return (value & field.mask) << field.shift;
}

std::uint32_t OusterPacketFormat::range(const std::uint8_t* column, int pixel,
                                        std::size_t which) const {
  return read(column, pixel, layout_.fields[which].range);
}

std::uint16_t OusterPacketFormat::reflectivity(const std::uint8_t* column, int pixel,
                                               std::size_t which) const {
  return static_cast<std::uint16_t>(read(column, pixel, layout_.fields[which].reflectivity));
}

}  // namespace toss
