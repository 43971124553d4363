// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/ScanSource.h>

#include <string>

namespace toss {

/// Enters a delivered scan into the report.
void countScan(const PointCloud& points, InputReport& report);

/// The sensor model of a source with one sensor: recognised from the first scans that are not empty
/// and kept, so that it costs nothing from then on and does not change on the way.
class SensorMemory {
 public:
  /// Model of `scan`, which is one of the source's; "" while unknown.
  const std::string& modelOf(const PosedScan& scan);

 private:
  std::string model_;
  int triesLeft_ = 10;
};

}  // namespace toss
