// SPDX-License-Identifier: BSD-3-Clause
#include "KittiFolderSource.h"

#include <toss/geometry/Error.h>

#include "KittiPoints.h"
#include "ScanBookkeeping.h"
#include "SensorLabels.h"

namespace toss {

KittiFolderSource::KittiFolderSource(const std::filesystem::path& folder,
                                     const InputOptions& options)
    : folder_(readKittiFolder(folder, options)) {
  if (!options.sensorLabel.empty() && options.sensorLabel != kLidarLabel)
    throw UserError("input.sensor_label", "a KITTI folder has one sensor, labelled LIDAR",
                    "leave the option away");
  if (options.deskew == Deskew::Sweep)
    throw UserError("input.deskew=sweep", "is for rawlogs: scans of KITTI folders are compensated",
                    "leave it away, or make a rawlog of scans that are not");
  report_.warnings = folder_.warnings;
}

bool KittiFolderSource::next(PosedScan& scan) {
  while (next_ < folder_.scans.size() && !folder_.scans[next_].pose) {
    ++report_.skippedForPose;
    ++next_;
  }
  if (next_ == folder_.scans.size()) return false;

  const KittiScan& from = folder_.scans[next_++];
  readKittiPoints(from.file, scan.points);
  scan.index = from.number;
  scan.time = *from.time;
  scan.mapFromSensor = *from.pose;
  scan.robotFromSensor.setIdentity();
  scan.sensorLabel = kLidarLabel;
  scan.sensorModel.clear();
  scan.sensorModel = sensor_.modelOf(scan);
  countScan(scan.points, report_);
  return true;
}

double KittiFolderSource::progress() const {
  return static_cast<double>(next_) / static_cast<double>(folder_.scans.size());
}

}  // namespace toss
