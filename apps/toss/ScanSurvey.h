// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/rawlog/ScanSource.h>

#include <cstdint>
#include <string>
#include <vector>

#include "CheckFinding.h"

namespace toss {

/// Looks at every scan by itself: times, returns, sensor.
class ScanSurvey {
 public:
  void look(const PosedScan& scan);
  /// What was found; `report`: of the source of the scans.
  void report(const InputReport& report, Findings& findings) const;

  std::uint64_t scans() const { return times_.size(); }
  /// Name of the sensor, "" if unknown.
  const std::string& sensor() const { return sensor_; }

 private:
  void reportGaps(Findings& findings) const;
  void reportReturns(Findings& findings) const;

  std::vector<double> times_;
  std::string sensor_;
  std::uint64_t returns_ = 0, atOrigin_ = 0, notFinite_ = 0, empty_ = 0;
};

}  // namespace toss
