// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/PlyFile.h>

#include <iomanip>
#include <limits>
#include <sstream>
#include <vector>

#include "OutputStream.h"

namespace toss {
namespace {

constexpr std::size_t kPointsPerWrite = 4096;

// The count is known last, so the header is written twice. A comment takes up the difference in
// length: padding the number itself would make readers stumble.
std::string headerText(std::uint64_t count, PlyWriter::Layout layout,
                       const Eigen::Vector3d& offset) {
  constexpr int kLongestCount = std::numeric_limits<std::uint64_t>::digits10 + 1;
  const std::string number = std::to_string(count);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "ply\nformat binary_little_endian 1.0\ncomment coordinates in metres, map frame"
       << std::string(static_cast<std::size_t>(kLongestCount) - number.size(), ' ') << '\n';
  if (!offset.isZero(0.0))
    text << std::setprecision(17) << "comment offset " << offset.x() << ' ' << offset.y() << ' '
         << offset.z() << '\n';
  text << "element vertex " << number << '\n';
  for (const char* name : {"x", "y", "z", "intensity"}) text << "property float " << name << '\n';
  if (layout == PlyWriter::Layout::PointsWithTrack) text << "property float track\n";
  text << "end_header\n";
  return text.str();
}

}  // namespace

struct PlyWriter::Implementation {
  Implementation(const std::filesystem::path& path, Layout layoutOfFile,
                 const Eigen::Vector3d& offsetOfFile)
      : layout(layoutOfFile),
        offset(offsetOfFile),
        file(path),
        out(file.temporaryPath(), path.string(), OutputStream::Format::Plain) {
    writeHeader();
  }

  void writeHeader() {
    const std::string header = headerText(count, layout, offset);
    out.Write(header.data(), header.size());
  }

  void flush() {
    out.Write(buffer.data(), buffer.size() * sizeof(float));
    buffer.clear();
  }

  Layout layout;
  Eigen::Vector3d offset;
  AtomicFile file;
  OutputStream out;
  std::uint64_t count = 0;
  std::vector<float> buffer;
  bool closed = false;
};

PlyWriter::PlyWriter(const std::filesystem::path& file, Layout layout,
                     const Eigen::Vector3d& offset)
    : implementation_(std::make_unique<Implementation>(file, layout, offset)) {}

PlyWriter::~PlyWriter() = default;

void PlyWriter::add(const MapPoint& point, std::uint32_t track) {
  Implementation& self = *implementation_;
  self.buffer.insert(self.buffer.end(), {point.x, point.y, point.z, point.intensity});
  if (self.layout == Layout::PointsWithTrack) self.buffer.push_back(static_cast<float>(track));
  if (++self.count % kPointsPerWrite == 0) self.flush();
}

std::uint64_t PlyWriter::count() const {
  return implementation_->count;
}

void PlyWriter::close() {
  Implementation& self = *implementation_;
  if (self.closed) return;
  self.flush();
  self.out.Seek(0);
  self.writeHeader();
  self.out.close();
  self.closed = true;
}

std::filesystem::path PlyWriter::temporaryPath() const {
  return implementation_->file.temporaryPath();
}

void PlyWriter::finish() {
  close();
  implementation_->file.commit();
}

void writePly(const std::filesystem::path& file, const std::vector<MapPoint>& points,
              const Eigen::Vector3d& offset) {
  PlyWriter writer(file, PlyWriter::Layout::Points, offset);
  for (const MapPoint& point : points) writer.add(point);
  writer.finish();
}

}  // namespace toss
