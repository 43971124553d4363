// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

/// PCD files for tests, made byte by byte.
namespace toss::test {

enum class PcdData { Ascii, Binary, Compressed };

inline std::string bytesOfNumber(std::uint32_t number) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

/// LZF without any compression: runs of up to 32 literal bytes.
inline std::string lzfLiterals(const std::string& bytes) {
  std::string packed;
  for (std::size_t at = 0; at < bytes.size(); at += 32) {
    const std::string run = bytes.substr(at, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  return packed;
}

inline std::string pcdHeader(std::size_t points, const std::string& viewpoint) {
  const std::string count = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity\n"
         "SIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " +
         count + "\nHEIGHT 1\n" + (viewpoint.empty() ? "" : "VIEWPOINT " + viewpoint + "\n") +
         "POINTS " + count + "\n";
}

/// "tx ty tz qw qx qy qz"
inline std::string viewpointOf(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond turn(pose.linear());
  char text[240];
  std::snprintf(text, sizeof text, "%.9f %.9f %.9f %.12f %.12f %.12f %.12f", pose.translation().x(),
                pose.translation().y(), pose.translation().z(), turn.w(), turn.x(), turn.y(),
                turn.z());
  return text;
}

inline std::string pcdOf(const std::vector<MapPoint>& points, PcdData data,
                         const std::string& viewpoint) {
  std::string header = pcdHeader(points.size(), viewpoint), rows, columns[4];
  for (const MapPoint& point : points) {
    char line[120];
    std::snprintf(line, sizeof line, "%.9g %.9g %.9g %.9g\n", point.x, point.y, point.z,
                  point.intensity);
    const float values[] = {point.x, point.y, point.z, point.intensity};
    for (std::size_t i = 0; i < 4; ++i) {
      std::string bytes(4, '\0');
      std::memcpy(bytes.data(), &values[i], 4);
      if (data == PcdData::Binary) rows += bytes;
      columns[i] += bytes;
    }
    if (data == PcdData::Ascii) rows += line;
  }
  if (data == PcdData::Ascii) return header + "DATA ascii\n" + rows;
  if (data == PcdData::Binary) return header + "DATA binary\n" + rows;
  const std::string all = columns[0] + columns[1] + columns[2] + columns[3];
  const std::string packed = lzfLiterals(all);
  return header + "DATA binary_compressed\n" +
         bytesOfNumber(static_cast<std::uint32_t>(packed.size())) +
         bytesOfNumber(static_cast<std::uint32_t>(all.size())) + packed;
}

}  // namespace toss::test
