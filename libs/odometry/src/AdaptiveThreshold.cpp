// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/AdaptiveThreshold.h>

#include <cmath>

namespace toss {

AdaptiveThreshold::AdaptiveThreshold(double initial, double minMotion, double maxRange)
    : initial_(initial), minMotion_(minMotion), maxRange_(maxRange) {}

void AdaptiveThreshold::add(const Eigen::Isometry3d& deviation) {
  const double angle = Eigen::AngleAxisd(deviation.linear()).angle();
  const double error = deviation.translation().norm() + 2.0 * maxRange_ * std::sin(0.5 * angle);
  if (error <= minMotion_) return;
  sumOfSquares_ += error * error;
  ++count_;
}

double AdaptiveThreshold::sigma() const {
  return count_ == 0 ? initial_ : std::sqrt(sumOfSquares_ / count_);
}

}  // namespace toss
