// SPDX-License-Identifier: BSD-3-Clause
#include "KittiPoints.h"

#include <toss/geometry/Error.h>

#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace toss {
namespace {

constexpr std::size_t kFields = 4;
constexpr std::size_t kBytes = kFields * sizeof(float);

}  // namespace

void readKittiPoints(const std::filesystem::path& file, PointCloud& points) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) throw UserError(file.string(), "can't be read", "check that the file exists");
  if (bytes % kBytes != 0)
    throw UserError(file.string(),
                    "holds " + std::to_string(bytes) +
                        " bytes, which is no multiple of 16 (x y z intensity as float32)",
                    "copy the file again, it may be cut off, or leave the scan out");
  const std::size_t count = bytes / kBytes;
  thread_local std::vector<float> buffer;
  buffer.resize(count * kFields);
  in.read(reinterpret_cast<char*>(buffer.data()), static_cast<std::streamsize>(bytes));
  if (!in) throw UserError(file.string(), "can't be read to its end", "check the disk");
  points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    points.x[i] = buffer[kFields * i];
    points.y[i] = buffer[kFields * i + 1];
    points.z[i] = buffer[kFields * i + 2];
    points.intensity[i] = buffer[kFields * i + 3];
  }
}

void writeKittiPoints(const std::filesystem::path& file, const PointCloud& points) {
  std::vector<float> buffer(points.size() * kFields);
  for (std::size_t i = 0; i < points.size(); ++i) {
    buffer[kFields * i] = points.x[i];
    buffer[kFields * i + 1] = points.y[i];
    buffer[kFields * i + 2] = points.z[i];
    buffer[kFields * i + 3] = points.intensity.empty() ? 0.0f : points.intensity[i];
  }
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(buffer.data()),
            static_cast<std::streamsize>(buffer.size() * sizeof(float)));
  out.close();
  if (!out)
    throw UserError(file.string(), "can't be written",
                    "check the folder's permissions and the free space");
}

}  // namespace toss
