// SPDX-License-Identifier: BSD-3-Clause
// A point map of MRPT holds all x, then all y, z and intensities: each is one more way through the
// points.
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MetricMapFile.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "OutputStream.h"
#include "PointRecords.h"

namespace toss {
namespace {

constexpr std::size_t kColumns = 4, kRowsPerRead = 16384;

std::string serializedEmptyMap() {
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream).WriteObject(mrpt::maps::CPointsMapXYZI());
  return {static_cast<const char*>(stream.getRawBufferData()),
          static_cast<std::size_t>(stream.getTotalBytesCount())};
}

void copyColumn(const std::filesystem::path& ply, std::size_t column, OutputStream& out) {
  std::ifstream in(ply, std::ios::binary);
  const PointTable table = readPlyHeader(in, ply);
  std::vector<float> rows(kColumns * kRowsPerRead), values;
  for (std::uint64_t done = 0; done < table.rows; done += values.size()) {
    values.resize(std::min<std::uint64_t>(kRowsPerRead, table.rows - done));
    const std::size_t bytes = values.size() * kColumns * sizeof(float);
    if (!in.read(reinterpret_cast<char*>(rows.data()), static_cast<std::streamsize>(bytes)))
      throw UserError(ply.string(), "can't be read to its end", "check the disk");
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = rows[kColumns * i + column];
    out.Write(values.data(), values.size() * sizeof(float));
  }
}

std::uint32_t countOf(const std::filesystem::path& ply, const AtomicFile& file) {
  std::ifstream in(ply, std::ios::binary);
  const std::uint64_t rows = readPlyHeader(in, ply).rows;
  if (rows > std::numeric_limits<std::uint32_t>::max())
    throw UserError(file.finalPath().string(), "would hold more points than a map of MRPT can",
                    "raise map.voxel_size");
  return static_cast<std::uint32_t>(rows);
}

}  // namespace

void copyToMetricMap(const std::filesystem::path& ply, const AtomicFile& file) {
  // An object: length of the name of its class with the highest bit set, name, version; then the
  // number of points.
  const std::string empty = serializedEmptyMap();
  const std::size_t head = 2 + (static_cast<unsigned char>(empty[0]) & 0x7fu);
  const std::uint32_t count = countOf(ply, file);
  OutputStream out(file.temporaryPath(), file.finalPath().string(), OutputStream::Format::GzStored);
  out.Write(empty.data(), head);
  out.Write(&count, sizeof count);
  for (std::size_t column = 0; column < kColumns; ++column) copyColumn(ply, column, out);
  out.Write(empty.data() + head + sizeof count, empty.size() - head - sizeof count);
  out.close();
}

}  // namespace toss
