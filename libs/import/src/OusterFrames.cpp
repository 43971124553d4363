// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/OusterFrames.h>
#include <toss/import/UdpPackets.h>

#include <algorithm>

#include "OusterPacketFormat.h"
#include "OusterSender.h"

namespace toss {
namespace {

/// A packet may be overtaken by this many frames; one that is further back comes from a sensor that
/// began to count anew.
constexpr int kLatestFrames = 8;

void clear(OusterFrame& frame, const OusterMetadata& metadata, std::size_t returns) {
  frame.rows = metadata.pixelsPerColumn;
  frame.columns = metadata.columnsPerFrame;
  const auto columns = static_cast<std::size_t>(frame.columns);
  const std::size_t pixels = columns * static_cast<std::size_t>(frame.rows);
  frame.timestamp.assign(columns, 0);
  frame.measurementId.assign(columns, 0);
  frame.status.assign(columns, 0);
  frame.valid.assign(columns, 0);
  for (std::size_t i = 0; i < frame.returns.size(); ++i) {
    frame.returns[i].range.assign(i < returns ? pixels : 0, 0);
    frame.returns[i].reflectivity.assign(i < returns ? pixels : 0, 0);
  }
  frame.captureTime = 0;
  frame.captureTimestamp = 0;
}

}  // namespace

int OusterFrame::validColumns() const {
  return static_cast<int>(std::count(valid.begin(), valid.end(), 1));
}

struct OusterFrameReader::Implementation {
  Implementation(const std::filesystem::path& file, const OusterMetadata& m)
      : capture(file.string()),
        metadata(m),
        format(m),
        sender(findOusterSender(file, m, format)),
        packets(file) {}

  /// Whether the packet is one of the sensor's; counts what is not.
  bool accept(const UdpPacket& candidate) {
    const bool size = candidate.size == format.packetSize();
    if (!size) {
      report.wrongSize += sender.sent(candidate);
      return false;
    }
    const bool numbered = sender.serialNumber != 0;
    if (numbered ? format.serialNumber(candidate.payload) != sender.serialNumber
                 : !sender.sent(candidate)) {
      // A damaged packet may tell any number.
      const bool damaged =
          sender.checkSums && sender.sent(candidate) && !format.checkSumFits(candidate.payload);
      ++(damaged ? report.wrongCheckSum : report.otherSensors);
      return false;
    }
    if (sender.checkSums && !format.checkSumFits(candidate.payload)) {
      ++report.wrongCheckSum;
      return false;
    }
    const std::uint32_t start = format.initializationId(candidate.payload);
    report.restarted |= start != 0 && metadata.initializationId != 0 &&
                        start != (metadata.initializationId & 0xFFFFFFu);
    return true;
  }

  /// The next packet of the sensor; false at the end.
  bool nextPacket() {
    while (packets.next(packet))
      if (accept(packet)) return true;
    return false;
  }

  void take(OusterFrame& frame) {
    ++report.packets;
    for (int i = 0; i < metadata.columnsPerPacket; ++i)
      takeColumn(format.column(packet.payload, i), frame);
  }

  void takeColumn(const std::uint8_t* column, OusterFrame& frame) {
    const std::uint16_t id = OusterPacketFormat::measurementId(column);
    const std::uint32_t status = format.status(column);
    if (id >= frame.columns) {
      // Columns outside of the window fill up the last packet, without a status.
      report.wrongColumns += format.valid(status);
      return;
    }
    const std::uint64_t time = OusterPacketFormat::timestamp(column);
    frame.timestamp[id] = time;
    frame.measurementId[id] = id;
    frame.status[id] = status;
    frame.valid[id] = format.valid(status);
    if (!frame.valid[id]) return;
    if (frame.captureTime == 0) {
      frame.captureTime = packet.captureTime;
      frame.captureTimestamp = time;
    }
    for (std::size_t which = 0; which < format.returns(); ++which) {
      OusterFrame::Returns& returns = frame.returns[which];
      std::size_t pixel = id;
      for (int row = 0; row < frame.rows; ++row) {
        returns.range[pixel] = format.range(column, row, which);
        returns.reflectivity[pixel] = format.reflectivity(column, row, which);
        pixel += static_cast<std::size_t>(frame.columns);
      }
    }
  }

  /// Reads the packets of one frame; false where there are no more.
  bool readFrame(OusterFrame& frame) {
    if (!pending && !nextPacket()) return false;
    pending = false;
    clear(frame, metadata, format.returns());
    frame.id = format.frameId(packet.payload);
    take(frame);
    while (nextPacket()) {
      const auto ahead = static_cast<std::int16_t>(format.frameId(packet.payload) - frame.id);
      if (ahead == 0) {
        take(frame);
      } else if (ahead < 0 && ahead >= -kLatestFrames) {
        ++report.late;
      } else {
        pending = true;
        // Negative: the sensor counts anew.
        report.lostFrames += ahead > 1 ? static_cast<std::uint64_t>(ahead - 1) : 0;
        break;
      }
    }
    return true;
  }

  std::string capture;
  OusterMetadata metadata;
  OusterPacketFormat format;
  OusterSender sender;
  UdpPacketReader packets;
  UdpPacket packet;
  /// Whether `packet` is the first of the next frame.
  bool pending = false;
  OusterFrameReport report;
};

OusterFrameReader::OusterFrameReader(const std::filesystem::path& capture,
                                     const OusterMetadata& metadata)
    : implementation_(std::make_unique<Implementation>(capture, metadata)) {}

OusterFrameReader::~OusterFrameReader() = default;

bool OusterFrameReader::next(OusterFrame& frame) {
  Implementation& my = *implementation_;
  while (my.readFrame(frame)) {
    int measured = 0;
    for (int column = 0; column < frame.columns; ++column)
      measured += my.metadata.inWindow(column) && frame.valid[static_cast<std::size_t>(column)];
    my.report.lostColumns += static_cast<std::uint64_t>(my.metadata.columnsInWindow() - measured);
    if (frame.validColumns() == 0) continue;
    ++my.report.frames;
    return true;
  }
  return false;
}

double OusterFrameReader::progress() const {
  return implementation_->packets.progress();
}

const OusterFrameReport& OusterFrameReader::report() const {
  return implementation_->report;
}

std::vector<std::string> OusterFrameReader::warnings() const {
  const OusterFrameReport& report = implementation_->report;
  std::vector<std::string> warnings = implementation_->packets.warnings();
  const auto warn = [&](std::uint64_t count, const std::string& text) {
    if (count > 0)
      warnings.push_back(implementation_->capture + ": " + std::to_string(count) + " " + text);
  };
  warn(report.otherSensors,
       "packets of other sensors were left out; import them with their own "
       "metadata");
  warn(report.wrongSize,
       "packets of this sensor were left out, their size is not the one that "
       "the metadata tell");
  warn(report.wrongCheckSum, "packets were left out, their check sum is wrong");
  warn(report.late, "packets were left out, they came after their frame was over");
  warn(report.wrongColumns, "columns were left out, the metadata's mode has no such column");
  warn(report.lostColumns,
       "columns are missing, in the frames cut by the capture's start and end "
       "or lost on the way");
  warn(report.lostFrames, "whole frames are missing between others");
  if (report.restarted)
    warnings.push_back(implementation_->capture +
                       ": the sensor was started anew since its metadata were saved; make sure "
                       "that they are those of this sensor");
  return warnings;
}

}  // namespace toss
