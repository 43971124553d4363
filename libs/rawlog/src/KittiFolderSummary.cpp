// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>

#include <algorithm>
#include <system_error>

#include "KittiFolder.h"
#include "KittiPoints.h"
#include "ScanBookkeeping.h"
#include "SensorLabels.h"
#include "SummaryParts.h"

namespace toss {
namespace {

constexpr std::uint64_t kBytesPerPoint = 16;

void lookAtSizes(const KittiFolder& folder, StreamSummary& stream, InputSummary& summary) {
  for (const KittiScan& scan : folder.scans) {
    std::error_code error;
    const std::uint64_t bytes = std::filesystem::file_size(scan.file, error);
    if (error || bytes % kBytesPerPoint != 0) {
      summary.warnings.push_back(scan.file.string() +
                                 ": is no multiple of 16 bytes; copy the file again");
      continue;
    }
    const std::uint64_t points = bytes / kBytesPerPoint;
    stream.fewestPoints = stream.pointClouds ? std::min(stream.fewestPoints, points) : points;
    stream.mostPoints = std::max(stream.mostPoints, points);
    stream.points += points;
    stream.pointClouds = true;
    summary.bytes += bytes;
  }
}

std::string recognizeIn(const KittiFolder& folder) {
  SensorMemory memory;
  PosedScan scan;
  for (std::size_t i = 0; i < std::min<std::size_t>(folder.scans.size(), 10); ++i) {
    try {
      readKittiPoints(folder.scans[i].file, scan.points);
    } catch (const UserError&) {
      continue;  // already in the warnings
    }
    if (!memory.modelOf(scan).empty()) break;
  }
  return memory.modelOf(scan);
}

}  // namespace

void summarizeKittiFolder(const InputOptions& options, InputSummary& summary) {
  const KittiFolder folder = readKittiFolder(summary.path, options);
  summary.warnings = folder.warnings;
  StreamSummary stream;
  stream.label = kLidarLabel;
  stream.className = "KITTI .bin";
  stream.count = folder.scans.size();
  lookAtSizes(folder, stream, summary);
  stream.sensorModel = recognizeIn(folder);
  summary.scans = folder.scans.size();
  for (const KittiScan& scan : folder.scans) {
    if (!scan.pose) {
      ++summary.scansWithoutPose;
      continue;
    }
    const double time = *scan.time;
    if (summary.poses == 0) stream.firstTime = time;
    stream.lastTime = time;
    ++summary.poses;
    addPosition(scan.pose->translation(), summary);
  }
  summary.streams.push_back(stream);
}

}  // namespace toss
