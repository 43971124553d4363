// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/MetricMapFile.h>
#include <toss/rawlog/PlyFile.h>

#include <fstream>
#include <string>

#include "PointRecords.h"

namespace toss {
namespace {

enum class FileFormat { Ply, Pcd, MetricMap };

FileFormat recogniseFormat(std::istream& in, const std::filesystem::path& file) {
  std::string begin(16, '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  in.seekg(0);
  const auto startsWith = [&](std::string_view text) { return begin.rfind(text, 0) == 0; };
  if (startsWith("ply\n") || startsWith("ply\r")) return FileFormat::Ply;
  if (startsWith("# .PCD") || startsWith("VERSION")) return FileFormat::Pcd;
  if (startsWith("\x1f\x8b") || file.extension() == ".metricmap") return FileFormat::MetricMap;
  failReading(file, begin.empty() ? "is empty" : "is neither PLY nor PCD nor a metric map");
}

PointRows readFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw UserError(file.string(), "can not be read", "check the path and its permissions");
  const FileFormat format = recogniseFormat(in, file);
  if (format == FileFormat::MetricMap) return {readMetricMap(file), Eigen::Vector3d::Zero()};
  return readRows(in, format == FileFormat::Ply ? readPlyHeader(in, file) : readPcdHeader(in, file),
                  file);
}

}  // namespace

std::vector<MapPoint> readPointCloudFile(const std::filesystem::path& file) {
  PointRows rows = readFile(file);
  if (!rows.offset.isZero(0.0))
    for (MapPoint& point : rows.points) {
      point.x = static_cast<float>(point.x + rows.offset.x());
      point.y = static_cast<float>(point.y + rows.offset.y());
      point.z = static_cast<float>(point.z + rows.offset.z());
    }
  return std::move(rows.points);
}

std::vector<MapPoint> readPointCloudFile(const std::filesystem::path& file,
                                         Eigen::Vector3d& offset) {
  PointRows rows = readFile(file);
  offset = rows.offset;
  return std::move(rows.points);
}

}  // namespace toss
