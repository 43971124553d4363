// SPDX-License-Identifier: BSD-3-Clause
#include "SweepFile.h"

#include <toss/geometry/Error.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace toss {
namespace {

constexpr std::array<char, 8> kMagic = {'T', 'O', 'S', 'S', 'S', 'W', 'P', '1'};
constexpr std::uint32_t kRings = 1, kTimes = 2, kCompensated = 4;

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t points = 0, flags = 0;
};
static_assert(sizeof(Header) == 16, "the header is written as it lies in memory");

std::size_t bytesOf(const Header& header) {
  const std::size_t perPoint = ((header.flags & kRings) != 0 ? sizeof(std::uint16_t) : 0) +
                               ((header.flags & kTimes) != 0 ? sizeof(float) : 0);
  return sizeof(Header) + perPoint * header.points;
}

template <typename Value>
void write(std::ofstream& out, const std::vector<Value>& values) {
  out.write(reinterpret_cast<const char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(Value)));
}

template <typename Value>
void read(std::ifstream& in, std::size_t count, std::vector<Value>& values) {
  values.resize(count);
  in.read(reinterpret_cast<char*>(values.data()),
          static_cast<std::streamsize>(count * sizeof(Value)));
}

void checkTimes(const std::filesystem::path& file, const std::vector<float>& times) {
  for (const float time : times)
    if (!std::isfinite(time))
      throw UserError(file.string(), "holds a time that is no number", "import the log again");
}

}  // namespace

void writeSweep(const std::filesystem::path& file, const PosedScan& scan) {
  const PointCloud& points = scan.points;
  const auto fits = [&](std::size_t count) { return count == 0 || count == points.size(); };
  if (!fits(points.ring.size()) || !fits(points.time.size()))
    throw std::logic_error("writeSweep: one ring and one time per point, or none");
  Header header;
  header.points = static_cast<std::uint32_t>(points.size());
  header.flags = (points.ring.empty() ? 0 : kRings) | (points.time.empty() ? 0 : kTimes) |
                 (scan.motionCompensated ? kCompensated : 0);
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(&header), sizeof header);
  write(out, points.ring);
  write(out, points.time);
  out.close();
  if (!out)
    throw UserError(file.string(), "can't be written",
                    "check the folder's permissions and the free space");
}

void readSweep(const std::filesystem::path& file, PosedScan& scan) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  Header header;
  if (error || !in.read(reinterpret_cast<char*>(&header), sizeof header) ||
      header.magic != kMagic || bytes != bytesOf(header))
    throw UserError(file.string(), "is damaged: its size and its header do not agree",
                    "copy the folder again, or import the log again");
  if (header.points != scan.points.size())
    throw UserError(file.string(),
                    "is of a scan of " + std::to_string(header.points) +
                        " points, but the log's has " + std::to_string(scan.points.size()),
                    "put the folder there that was made with this rawlog, or remove it");
  read(in, (header.flags & kRings) != 0 ? header.points : 0, scan.points.ring);
  read(in, (header.flags & kTimes) != 0 ? header.points : 0, scan.points.time);
  if (!in) throw UserError(file.string(), "can't be read to its end", "check the disk");
  checkTimes(file, scan.points.time);
  scan.motionCompensated = (header.flags & kCompensated) != 0;
}

}  // namespace toss
