// SPDX-License-Identifier: BSD-3-Clause
#include "PointRecords.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>

namespace toss {
namespace {

constexpr double kFarFromOrigin = 10e3;
constexpr std::size_t kRowsPerRead = 8192;

template <typename Number>
double decode(const char* bytes, bool swap) {
  std::array<char, sizeof(Number)> copy;
  std::memcpy(copy.data(), bytes, sizeof(Number));
  if (swap) std::reverse(copy.begin(), copy.end());
  Number value;
  std::memcpy(&value, copy.data(), sizeof(Number));
  return static_cast<double>(value);
}

double decode(NumberType type, const char* bytes, bool swap) {
  switch (type) {
    case NumberType::Int8:
      return decode<std::int8_t>(bytes, swap);
    case NumberType::UInt8:
      return decode<std::uint8_t>(bytes, swap);
    case NumberType::Int16:
      return decode<std::int16_t>(bytes, swap);
    case NumberType::UInt16:
      return decode<std::uint16_t>(bytes, swap);
    case NumberType::Int32:
      return decode<std::int32_t>(bytes, swap);
    case NumberType::UInt32:
      return decode<std::uint32_t>(bytes, swap);
    case NumberType::Float32:
      return decode<float>(bytes, swap);
    case NumberType::Float64:
      return decode<double>(bytes, swap);
  }
  return 0.0;
}

/// Where x, y, z and intensity stand in a row: byte for binary rows, cell for ascii ones.
struct Column {
  std::size_t byte = 0, cell = 0;
  NumberType type = NumberType::Float32;
};

std::optional<Column> findColumn(const PointTable& table, std::string_view name) {
  Column column;
  for (const PointTable::Field& field : table.fields) {
    column.type = field.type;
    if (field.name == name && field.count > 0) return column;
    column.byte += field.count * sizeOf(field.type);
    column.cell += field.count;
  }
  return std::nullopt;
}

class RowReader {
 public:
  RowReader(const PointTable& table, const std::filesystem::path& file)
      : table_(table), file_(file) {
    constexpr std::array<const char*, 3> kCoordinates = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto column = findColumn(table, kCoordinates[i]);
      if (!column) failReading(file, std::string("holds no coordinate '") + kCoordinates[i] + "'");
      columns_[i] = *column;
    }
    for (const char* name : {"intensity", "scalar_intensity", "scalar_Intensity", "reflectance",
                             "reflectivity", "remission"})
      if (!intensity_) intensity_ = findColumn(table, name);
    for (const PointTable::Field& field : table.fields) {
      rowBytes_ += field.count * sizeOf(field.type);
      rowCells_ += field.count;
    }
    if (table.offset) result_.offset = *table.offset;
  }

  PointRows read(std::istream& in) {
    const std::uint64_t shortest = table_.ascii ? 2 * rowCells_ - 1 : rowBytes_;
    const auto begin = in.tellg();
    in.seekg(0, std::ios::end);
    const auto end = in.tellg();
    if (end < begin) failReading(file_, "is cut short before its points");
    const auto available = static_cast<std::uint64_t>(end - begin);
    in.seekg(begin);
    // An ascii file may lack the last line's end.
    if (table_.rows > (available + (table_.ascii ? 1 : 0)) / shortest)
      failReading(file_, "is cut short: its header tells of " + std::to_string(table_.rows) +
                             " points, more than its size can hold");
    result_.points.reserve(table_.rows);
    table_.ascii ? readAscii(in) : readBinary(in);
    return std::move(result_);
  }

 private:
  void readBinary(std::istream& in) {
    std::vector<char> chunk(std::min<std::uint64_t>(kRowsPerRead, table_.rows) * rowBytes_);
    for (std::uint64_t done = 0; done < table_.rows;) {
      const auto rows = std::min<std::uint64_t>(kRowsPerRead, table_.rows - done);
      if (!in.read(chunk.data(), static_cast<std::streamsize>(rows * rowBytes_)))
        failReading(file_, "is cut short after point " + std::to_string(done));
      for (std::uint64_t row = 0; row < rows; ++row) addBinary(chunk.data() + row * rowBytes_);
      done += rows;
    }
  }

  void addBinary(const char* row) {
    Eigen::Vector3d position;
    for (std::size_t i = 0; i < 3; ++i)
      position[static_cast<Eigen::Index>(i)] =
          decode(columns_[i].type, row + columns_[i].byte, table_.bigEndian);
    add(position,
        intensity_ ? decode(intensity_->type, row + intensity_->byte, table_.bigEndian) : 0.0);
  }

  void readAscii(std::istream& in) {
    std::string line;
    std::vector<double> values;
    for (std::uint64_t row = 0; row < table_.rows;) {
      if (!std::getline(in, line))
        failReading(file_, "is cut short after point " + std::to_string(row));
      parseAscii(line, row, values);
      if (values.empty()) continue;
      Eigen::Vector3d position(values[columns_[0].cell], values[columns_[1].cell],
                               values[columns_[2].cell]);
      add(position, intensity_ ? values[intensity_->cell] : 0.0);
      ++row;
    }
  }

  void parseAscii(const std::string& line, std::uint64_t row, std::vector<double>& values) const {
    values.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    for (;;) {
      while (at != end && (*at == ' ' || *at == '\t' || *at == '\r' || *at == '+')) ++at;
      if (at == end) break;
      double value = 0.0;
      const auto [next, error] = std::from_chars(at, end, value);
      if (error == std::errc::invalid_argument)
        failReading(file_, "point " + std::to_string(row) + " is no row of numbers");
      values.push_back(value);
      at = next;
    }
    if (!values.empty() && values.size() < rowCells_)
      failReading(file_, "point " + std::to_string(row) + " has only " +
                             std::to_string(values.size()) + " values");
  }

  void add(const Eigen::Vector3d& position, double intensity) {
    if (!position.allFinite()) return;
    if (result_.points.empty() && !table_.offset && columns_[0].type == NumberType::Float64 &&
        position.cwiseAbs().maxCoeff() > kFarFromOrigin)
      shift_ = result_.offset = position.array().round();
    const Eigen::Vector3f relative = (position - shift_).cast<float>();
    result_.points.push_back({relative.x(), relative.y(), relative.z(),
                              std::isfinite(intensity) ? static_cast<float>(intensity) : 0.0f});
  }

  const PointTable& table_;
  const std::filesystem::path& file_;
  std::array<Column, 3> columns_;
  std::optional<Column> intensity_;
  std::size_t rowBytes_ = 0, rowCells_ = 0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
  PointRows result_;
};

}  // namespace

PointRows readRows(std::istream& in, const PointTable& table, const std::filesystem::path& file) {
  if (!table.compressed) return RowReader(table, file).read(in);
  std::istringstream rows(decompressRows(in, table, file));
  return RowReader(table, file).read(rows);
}

}  // namespace toss
