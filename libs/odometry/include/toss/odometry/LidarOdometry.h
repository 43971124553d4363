// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>
#include <toss/odometry/AdaptiveThreshold.h>
#include <toss/odometry/LocalMap.h>
#include <toss/odometry/OdometryOptions.h>
#include <toss/odometry/Registration.h>

#include <optional>
#include <vector>

namespace toss {

/// Finds the poses of scans from the scans alone: each is aligned to a map of the last ones,
/// beginning where a constant velocity leads (Vizzo et al., KISS-ICP, RA-L 2023). Poses drift:
/// errors add up along the way. One per thread.
class LidarOdometry {
 public:
  /// Throws UserError for options out of range.
  explicit LidarOdometry(const OdometryOptions& options);

  /// Pose (map <- sensor) of the next scan, later than the one before; the map frame is the sensor
  /// frame of the first scan. Returns that carry times and are not compensated are de-skewed
  /// with the predicted velocity; the pose is that of the scan's time stamp. A scan without returns
  /// keeps to the prediction.
  Eigen::Isometry3d add(const PosedScan& scan);

  /// How well the last scan was aligned: iterations, overlap with the local map.
  const Alignment& alignment() const { return alignment_; }
  /// sigma of the adaptive threshold [m].
  double threshold() const { return threshold_.sigma(); }

 private:
  void takeScan(const PosedScan& scan, const Eigen::Isometry3d& motion, double period);

  OdometryOptions options_;
  LocalMap map_;
  AdaptiveThreshold threshold_;
  Alignment alignment_;
  /// Returns in range [m, sensor frame], thinned for the map, and thinned for the alignment.
  std::vector<Eigen::Vector3d> points_, mapPoints_, sourcePoints_;
  /// Numbers in the scan of points_.
  std::vector<std::size_t> index_;
  /// Poses (map <- sensor) and times [s] of the scan before and of the one before that.
  Eigen::Isometry3d last_ = Eigen::Isometry3d::Identity();
  /// last <- next, if the motion goes on as it was, and the time that it takes [s].
  Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
  double lastTime_ = 0.0, period_ = 0.0;
  std::uint64_t count_ = 0;
};

/// The motion that takes `share` of the time of `motion` at the same velocities; share 0 gives the
/// identity and 1 the motion itself.
Eigen::Isometry3d shareOf(const Eigen::Isometry3d& motion, double share);

}  // namespace toss
