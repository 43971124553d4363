// SPDX-License-Identifier: BSD-3-Clause
#include "ScanBookkeeping.h"

#include <toss/rawlog/SensorRecognition.h>

#include <cmath>

namespace toss {

void countScan(const PointCloud& points, InputReport& report) {
  std::uint64_t notFinite = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    notFinite += !std::isfinite(points.x[i] + points.y[i] + points.z[i]);
  ++report.scans;
  report.empty += points.empty();
  report.points += points.size();
  report.notFinite += notFinite;
}

const std::string& SensorMemory::modelOf(const PosedScan& scan) {
  if (model_.empty() && triesLeft_ > 0 && !scan.points.empty()) {
    model_ = recognizeSensor(scan);
    --triesLeft_;
  }
  return model_;
}

}  // namespace toss
