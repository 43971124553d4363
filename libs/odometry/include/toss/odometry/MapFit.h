// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/odometry/LocalMap.h>
#include <toss/odometry/OdometryOptions.h>

#include <vector>

namespace toss {

/// How sharply scans lie on each other under poses that are given: each is compared with a map of
/// the ones before it, as LidarOdometry does, but not moved.
class MapFit {
 public:
  explicit MapFit(const OdometryOptions& options);

  /// Alignment::fit of the scan at `mapFromSensor`, 0 to 1; 0 for the first. Then adds it.
  double add(const PosedScan& scan, const Eigen::Isometry3d& mapFromSensor);

 private:
  OdometryOptions options_;
  LocalMap map_;
  std::vector<Eigen::Vector3d> points_, mapPoints_, sourcePoints_;
};

}  // namespace toss
