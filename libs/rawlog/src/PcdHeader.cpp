// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>

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
  std::vector<std::string> names, sizes, types, counts, data, points, width, height, viewpoint;

  std::vector<std::string>* lineOf(const std::string& keyword) {
    if (keyword == "FIELDS" || keyword == "COLUMNS") return &names;
    if (keyword == "SIZE") return &sizes;
    if (keyword == "TYPE") return &types;
    if (keyword == "COUNT") return &counts;
    if (keyword == "DATA") return &data;
    if (keyword == "POINTS") return &points;
    if (keyword == "WIDTH") return &width;
    if (keyword == "HEIGHT") return &height;
    if (keyword == "VIEWPOINT") return &viewpoint;
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

/// "tx ty tz qw qx qy qz"
std::optional<Eigen::Isometry3d> viewpointOf(const PcdHeader& header,
                                             const std::filesystem::path& file) {
  if (header.viewpoint.empty()) return std::nullopt;
  std::array<double, 7> v{};
  if (header.viewpoint.size() != v.size()) failReading(file, "its VIEWPOINT is no pose");
  for (std::size_t i = 0; i < v.size(); ++i) {
    const std::string& word = header.viewpoint[i];
    const char* const end = word.data() + word.size();
    const auto [next, error] = std::from_chars(word.data() + (word[0] == '+'), end, v[i]);
    if (error != std::errc() || next != end || !std::isfinite(v[i]))
      failReading(file, "its VIEWPOINT is no pose");
  }
  const Eigen::Quaterniond turn(v[3], v[4], v[5], v[6]);
  // Six decimals, as programs write them, leave norms this far from 1.
  if (std::abs(turn.norm() - 1.0) > 1e-3) failReading(file, "its VIEWPOINT is no pose");
  Eigen::Isometry3d pose(turn.normalized());
  pose.translation() << v[0], v[1], v[2];
  return pose;
}

PointTable toTable(const PcdHeader& header, const std::filesystem::path& file) {
  const std::size_t fields = header.names.size();
  if (header.sizes.size() != fields || header.types.size() != fields ||
      (!header.counts.empty() && header.counts.size() != fields))
    failReading(file, "its FIELDS, SIZE, TYPE and COUNT differ in number");
  PointTable table;
  table.rows = rowsOf(header, file);
  table.ascii = header.data[0] == "ascii";
  table.compressed = header.data[0] == "binary_compressed";
  table.viewpoint = viewpointOf(header, file);
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
  if (header.data[0] != "ascii" && header.data[0] != "binary" &&
      header.data[0] != "binary_compressed")
    failReading(file, "its DATA is neither ascii nor binary nor binary_compressed");
  return toTable(header, file);
}

}  // namespace toss
