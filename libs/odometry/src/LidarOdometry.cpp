// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/Downsampling.h>
#include <toss/odometry/LidarOdometry.h>

#include <cmath>

#include "StartSearch.h"

namespace toss {
namespace {

/// Shares of the map's voxel size to which scans are thinned (KISS-ICP, section III-B).
constexpr double kMapThinning = 0.5, kSourceThinning = 1.5;

}  // namespace

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

void LidarOdometry::takePoints(const PosedScan& scan, const Eigen::Isometry3d& motion,
                               double period) {
  const PointCloud& cloud = scan.points;
  const double nearest = options_.minRange * options_.minRange;
  const double farthest = options_.maxRange * options_.maxRange;
  const bool skewed = cloud.time.size() == cloud.size() && !scan.motionCompensated && period > 0.0;
  points_.clear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d point(cloud.x[i], cloud.y[i], cloud.z[i]);
    const double squared = point.squaredNorm();
    // Not so for NaN either.
    if (!(squared > nearest && squared < farthest)) continue;
    points_.push_back(skewed ? shareOf(motion, cloud.time[i] / period) * point : point);
  }
  const double size = options_.effectiveVoxelSize();
  downsample(points_, kMapThinning * size, mapPoints_);
  downsample(mapPoints_, kSourceThinning * size, sourcePoints_);
}

Eigen::Isometry3d LidarOdometry::add(const PosedScan& scan) {
  const double period = count_ == 0 ? 0.0 : scan.time - lastTime_;
  const Eigen::Isometry3d motion =
      period_ > 0.0 ? shareOf(motion_, period / period_) : Eigen::Isometry3d::Identity();
  takePoints(scan, motion, period);
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
