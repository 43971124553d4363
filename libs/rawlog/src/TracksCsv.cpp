// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/TracksCsv.h>

#include <charconv>
#include <string>

#include "OutputStream.h"
#include "TracksCsvColumns.h"

namespace toss {
namespace {

void appendNumber(std::string& line, double value, int decimals) {
  char text[400];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  line.append(1, ',').append(text, end);
}

std::string rowText(const ScanLabels& labels, const TrackSample& sample) {
  std::string line = std::to_string(labels.scan);
  appendNumber(line, labels.time, 6);
  line += ',' + std::to_string(sample.track) + (sample.moving ? ",moving" : ",static");
  const Box& box = sample.box;
  for (const double value :
       {box.center.x(), box.center.y(), box.center.z(), box.yaw, box.length, box.width, box.height,
        sample.velocity.x(), sample.velocity.y(), sample.velocity.z()})
    appendNumber(line, value, 4);
  return line + '\n';
}

std::string headerText() {
  std::string line;
  for (const char* name : kTracksCsvColumns) line.append(line.empty() ? "" : ",").append(name);
  return line + '\n';
}

}  // namespace

struct TracksCsvWriter::Implementation {
  explicit Implementation(const std::filesystem::path& path)
      : file(path), out(file.temporaryPath(), path.string(), OutputStream::Format::Plain) {
    write(headerText());
  }
  void write(const std::string& text) { out.Write(text.data(), text.size()); }

  AtomicFile file;
  OutputStream out;
};

TracksCsvWriter::TracksCsvWriter(const std::filesystem::path& file)
    : implementation_(std::make_unique<Implementation>(file)) {}

TracksCsvWriter::~TracksCsvWriter() = default;

void TracksCsvWriter::add(const ScanLabels& labels) {
  for (const TrackSample& sample : labels.tracks) implementation_->write(rowText(labels, sample));
}

void TracksCsvWriter::finish() {
  implementation_->out.close();
  implementation_->file.commit();
}

}  // namespace toss
