// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace toss {

enum class NumberType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::size_t sizeOf(NumberType type);

/// The rows of a point file: what PLY and PCD headers come down to.
struct PointTable {
  struct Field {
    std::string name;
    NumberType type = NumberType::Float32;
    /// Values in a row, of which only the first is read.
    std::size_t count = 1;
  };
  std::vector<Field> fields;
  std::uint64_t rows = 0;
  bool ascii = false;
  bool bigEndian = false;
  /// PCD "binary_compressed": column after column, as one block of LZF.
  bool compressed = false;
  /// What has to be added to the coordinates [m], if the file tells.
  std::optional<Eigen::Vector3d> offset;
  /// VIEWPOINT of a PCD [m]; none where the header has no such line.
  std::optional<Eigen::Isometry3d> viewpoint;
};

/// What reading a point file gives.
struct PointRows {
  std::vector<MapPoint> points;
  /// What has to be added to the coordinates [m].
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Reads the rows from where the header ended. Throws UserError naming file and row.
PointRows readRows(std::istream& in, const PointTable& table, const std::filesystem::path& file);

/// Headers of the two formats; `in` is left at the first row.
PointTable readPlyHeader(std::istream& in, const std::filesystem::path& file);
PointTable readPcdHeader(std::istream& in, const std::filesystem::path& file);

/// The rows of a compressed PCD as an uncompressed one holds them. Throws UserError where the block
/// is damaged.
std::string decompressRows(std::istream& in, const PointTable& table,
                           const std::filesystem::path& file);

/// Reads a line of a header, without its end; false at the end of the file. Throws UserError for
/// lines longer than any header has: the file is something else.
bool readHeaderLine(std::istream& in, std::string& line, const std::filesystem::path& file);
std::vector<std::string> splitAtBlanks(std::string_view line);
/// The whole number that `text` is. Throws UserError naming `what`.
std::uint64_t parseCount(const std::string& text, const std::filesystem::path& file,
                         const std::string& what);
[[noreturn]] void failReading(const std::filesystem::path& file, const std::string& problem);

}  // namespace toss
