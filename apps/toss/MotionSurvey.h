// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/odometry/LidarOdometry.h>
#include <toss/odometry/MapFit.h>
#include <toss/odometry/PoseJudgement.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "CheckFinding.h"

namespace toss {

/// Compares the poses of a log with the motion that the scans themselves show: in stretches of the
/// log, ever farther apart, so that long logs take little longer.
class MotionSurvey {
 public:
  /// `posed`: whether the scans carry poses that are to be judged.
  MotionSurvey(const OdometryOptions& options, bool posed);

  void look(const PosedScan& scan);
  void report(Findings& findings) const;

 private:
  void begin();
  void reportSweeps(Findings& findings) const;

  OdometryOptions options_;
  bool posed_;
  std::uint64_t count_ = 0, stretchBegin_ = 0, pause_ = 0;
  std::optional<LidarOdometry> odometry_;
  std::optional<MapFit> givenFit_, foundFit_;
  std::vector<MotionStretch> stretches_;
  /// Whether returns tell when in the sweep they were measured.
  bool timed_ = false;
};

}  // namespace toss
