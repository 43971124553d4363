// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/LidarOdometry.h>

#include <cmath>

#include "ScanThinning.h"
#include "StartSearch.h"

namespace toss {
Eigen::Isometry3d shareOf(const Eigen::Isometry3d& motion, double share) {
  const Eigen::AngleAxisd rotation(motion.linear());
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::AngleAxisd(share * rotation.angle(), rotation.axis()).toRotationMatrix();
  result.translation() = share * motion.translation();
  return result;
}

LidarOdometry::LidarOdometry(const OdometryOptions& options)
    : options_(options),
      map_(options.effectiveVoxelSize(), options.pointsPerVoxel),
      threshold_(options.initialThreshold, options.minMotion, options.maxRange) {
  options.check();
}

void LidarOdometry::takeScan(const PosedScan& scan, const Eigen::Isometry3d& motion,
                             double period) {
  const std::vector<float>& times = scan.points.time;
  takePoints(scan.points, options_, points_, &index_);
  const bool skewed = times.size() == scan.points.size() && !scan.motionCompensated && period > 0.0;
  if (skewed)
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = shareOf(motion, times[index_[i]] / period) * points_[i];
  thin(points_, options_, mapPoints_, sourcePoints_);
}

Eigen::Isometry3d LidarOdometry::add(const PosedScan& scan) {
  const double period = count_ == 0 ? 0.0 : scan.time - lastTime_;
  const Eigen::Isometry3d motion =
      period_ > 0.0 ? shareOf(motion_, period / period_) : Eigen::Isometry3d::Identity();
  takeScan(scan, motion, period);
  const double sigma = threshold_.sigma();
  const RegistrationLimits limits = {3.0 * sigma, sigma / 3.0, options_.maxIterations,
                                     options_.convergence};
  const Eigen::Isometry3d prediction =
      count_ == 1 ? findStart(sourcePoints_, map_, last_, options_.startSpeed * period, limits)
                  : last_ * motion;
  alignment_ = align(sourcePoints_, map_, prediction, limits);
  const Eigen::Isometry3d pose = alignment_.mapFromSensor;
  threshold_.add(prediction.inverse() * pose);

  for (Eigen::Vector3d& point : mapPoints_) point = pose * point;
  map_.add(mapPoints_, pose.linear().col(2));
  map_.forgetBeyond(pose.translation(), options_.maxRange);
  motion_ = last_.inverse() * pose;
  period_ = period;
  last_ = pose;
  lastTime_ = scan.time;
  ++count_;
  return pose;
}

}  // namespace toss
