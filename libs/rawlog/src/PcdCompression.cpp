// SPDX-License-Identifier: BSD-3-Clause
// PCD "binary_compressed": two little-endian uint32, the size of the block as stored and as it is
// unpacked, then a block of LZF with all values of the first field, all of the second, ...
#include <lzf.h>

#include <algorithm>

#include "PointRecords.h"

namespace toss {
namespace {

std::uint32_t littleEndianUint32(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::size_t bytesOf(const PointTable::Field& field) {
  return field.count * sizeOf(field.type);
}

/// The block as it is unpacked; `size` bytes.
std::string unpack(std::istream& in, std::size_t size, const std::filesystem::path& file) {
  char header[8];
  if (!in.read(header, sizeof header)) failReading(file, "is cut short before its points");
  const std::size_t stored = littleEndianUint32(header);
  if (littleEndianUint32(header + 4) != size)
    failReading(file, "the size of its compressed points is not that of its header");
  const auto begin = in.tellg();
  in.seekg(0, std::ios::end);
  if (stored > static_cast<std::size_t>(in.tellg() - begin))
    failReading(file, "is cut short within its compressed points");
  in.seekg(begin);
  std::string packed(stored, '\0');
  in.read(packed.data(), static_cast<std::streamsize>(stored));
  std::string unpacked(size, '\0');
  const unsigned int got = lzf_decompress(packed.data(), static_cast<unsigned int>(stored),
                                          unpacked.data(), static_cast<unsigned int>(size));
  if (got != size) failReading(file, "its compressed points are damaged");
  return unpacked;
}

}  // namespace

std::string decompressRows(std::istream& in, const PointTable& table,
                           const std::filesystem::path& file) {
  std::size_t rowBytes = 0;
  for (const PointTable::Field& field : table.fields) rowBytes += bytesOf(field);
  // The format's sizes have 32 bits.
  constexpr std::uint64_t kLargest = 0xFFFFFFFFu;
  if (rowBytes == 0 || table.rows > kLargest / rowBytes)
    failReading(file, "its header tells of more points than a compressed PCD can hold");
  if (table.rows == 0) return "";
  const std::size_t rows = table.rows;
  const std::string columns = unpack(in, rows * rowBytes, file);
  std::string result(columns.size(), '\0');
  std::size_t column = 0, place = 0;
  for (const PointTable::Field& field : table.fields) {
    const std::size_t width = bytesOf(field);
    for (std::size_t row = 0; row < rows; ++row)
      std::copy_n(columns.data() + column + row * width, width,
                  result.data() + row * rowBytes + place);
    column += rows * width;
    place += width;
  }
  return result;
}

}  // namespace toss
