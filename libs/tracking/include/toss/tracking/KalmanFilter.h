// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/tracking/KalmanNoise.h>

namespace toss {

/// The paper's 10-state box filter [x y z theta l w h vx vy vz], written as what it is: three
/// constant-velocity filters that share their covariance, and four scalar filters (spec section
/// 5.2). Equal to the dense filter up to rounding.
class KalmanFilter {
 public:
  /// Starts at the first measured box with velocity 0.
  KalmanFilter(const Box& first, const KalmanNoise& noise);

  /// Moves the estimate forward by noise.step.
  void predict(const KalmanNoise& noise);
  /// Takes a measured box in. Its yaw may be that of any of the four descriptions of the box.
  void update(const Box& measured, const KalmanNoise& noise);

  /// Estimated box, map frame; yaw in [-pi/2, pi/2).
  const Box& box() const { return box_; }
  /// Estimated velocity of the centre [m per unit of step].
  const Eigen::Vector3d& velocity() const { return velocity_; }
  /// Variance of each coordinate of the centre [m^2].
  double positionVariance() const { return positionVariance_; }
  /// Variance of each coordinate of the velocity [m^2 per squared unit of step].
  double velocityVariance() const { return velocityVariance_; }

 private:
  void updateCenter(const Eigen::Vector3d& measured, double noise);
  void updateSize(const Box& measured, double noise);
  void updateYaw(double measured, double noise);

  Box box_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  double positionVariance_, covariance_ = 0.0, velocityVariance_;
  double sizeVariance_, yawVariance_;
};

}  // namespace toss
