// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>

#include "PointRecords.h"

namespace toss {
namespace {

NumberType pcdType(const std::string& kind, const std::string& size,
                   const std::filesystem::path& file) {
  const std::string name = kind + size;
  if (name == "I1") return NumberType::Int8;
  if (name == "U1") return NumberType::UInt8;
  if (name == "I2") return NumberType::Int16;
  if (name == "U2") return NumberType::UInt16;
  if (name == "I4") return NumberType::Int32;
  if (name == "U4") return NumberType::UInt32;
  if (name == "F4") return NumberType::Float32;
  if (name == "F8") return NumberType::Float64;
  failReading(file, "has a field of unknown type " + name);
}

/// The lines of a header as they stand there; each is a list of words after its keyword.
struct PcdHeader {
  std::vector<std::string> names, sizes, types, counts, data, points, width, height;

  std::vector<std::string>* lineOf(const std::string& keyword) {
    if (keyword == "FIELDS" || keyword == "COLUMNS") return &names;
    if (keyword == "SIZE") return &sizes;
    if (keyword == "TYPE") return &types;
    if (keyword == "COUNT") return &counts;
    if (keyword == "DATA") return &data;
    if (keyword == "POINTS") return &points;
    if (keyword == "WIDTH") return &width;
    if (keyword == "HEIGHT") return &height;
    return nullptr;
  }
};

std::uint64_t rowsOf(const PcdHeader& header, const std::filesystem::path& file) {
  if (header.points.size() == 1) return parseCount(header.points[0], file, "its POINTS");
  if (header.width.size() != 1 || header.height.size() != 1)
    failReading(file, "its header does not tell the number of points");
  const std::uint64_t width = parseCount(header.width[0], file, "its WIDTH");
  const std::uint64_t height = parseCount(header.height[0], file, "its HEIGHT");
  std::uint64_t rows = 0;
  if (__builtin_mul_overflow(width, height, &rows)) failReading(file, "its WIDTH is damaged");
  return rows;
}

PointTable toTable(const PcdHeader& header, const std::filesystem::path& file) {
  const std::size_t fields = header.names.size();
  if (header.sizes.size() != fields || header.types.size() != fields ||
      (!header.counts.empty() && header.counts.size() != fields))
    failReading(file, "its FIELDS, SIZE, TYPE and COUNT differ in number");
  PointTable table;
  table.rows = rowsOf(header, file);
  table.ascii = header.data[0] == "ascii";
  for (std::size_t i = 0; i < fields; ++i) {
    const std::uint64_t count =
        header.counts.empty() ? 1 : parseCount(header.counts[i], file, "its COUNT");
    if (count > 65536) failReading(file, "its COUNT is damaged");
    table.fields.push_back(
        {header.names[i], pcdType(header.types[i], header.sizes[i], file), count});
  }
  return table;
}

}  // namespace

PointTable readPcdHeader(std::istream& in, const std::filesystem::path& file) {
  PcdHeader header;
  std::string line;
  while (header.data.empty()) {
    if (!readHeaderLine(in, line, file)) failReading(file, "its header has no line DATA");
    std::vector<std::string> words = splitAtBlanks(line);
    if (words.empty() || words[0][0] == '#') continue;
    if (std::vector<std::string>* target = header.lineOf(words[0]))
      target->assign(words.begin() + 1, words.end());
  }
  if (header.data[0] == "binary_compressed")
    throw UserError(file.string(), "is a compressed PCD, which is not read",
                    "convert it: pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1");
  if (header.data[0] != "ascii" && header.data[0] != "binary")
    failReading(file, "its DATA is neither ascii nor binary");
  return toTable(header, file);
}

}  // namespace toss
