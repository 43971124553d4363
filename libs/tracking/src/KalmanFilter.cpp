// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/HeadingCorrection.h>
#include <toss/tracking/KalmanFilter.h>

#include <algorithm>

namespace toss {

KalmanFilter::KalmanFilter(const Box& first, const KalmanNoise& noise)
    : box_(first),
      positionVariance_(noise.initialPosition),
      velocityVariance_(noise.initialVelocity),
      sizeVariance_(noise.initialSize),
      yawVariance_(noise.initialYaw) {}

void KalmanFilter::predict(const KalmanNoise& noise) {
  const double step = noise.step;
  box_.center += step * velocity_;
  positionVariance_ += 2.0 * step * covariance_ + step * step * velocityVariance_ + noise.position;
  covariance_ += step * velocityVariance_ + noise.positionVelocity;
  velocityVariance_ += noise.velocity;
  sizeVariance_ += noise.size;
  yawVariance_ += noise.yaw;
}

void KalmanFilter::update(const Box& measured, const KalmanNoise& noise) {
  const Box aligned = alignedWithYaw(measured, box_.yaw);
  updateCenter(aligned.center, noise.measuredPosition);
  updateSize(aligned, noise.measuredSize);
  updateYaw(aligned.yaw, noise.measuredYaw);
}

void KalmanFilter::updateCenter(const Eigen::Vector3d& measured, double noise) {
  const double innovationVariance = positionVariance_ + noise;
  const double positionGain = positionVariance_ / innovationVariance;
  const double velocityGain = covariance_ / innovationVariance;
  const Eigen::Vector3d innovation = measured - box_.center;
  box_.center += positionGain * innovation;
  velocity_ += velocityGain * innovation;
  velocityVariance_ -= velocityGain * covariance_;
  covariance_ *= 1.0 - positionGain;
  positionVariance_ *= 1.0 - positionGain;
}

void KalmanFilter::updateSize(const Box& measured, double noise) {
  const double gain = sizeVariance_ / (sizeVariance_ + noise);
  box_.length += gain * (measured.length - box_.length);
  box_.width += gain * (measured.width - box_.width);
  box_.height += gain * (measured.height - box_.height);
  sizeVariance_ *= 1.0 - gain;
}

void KalmanFilter::updateYaw(double measured, double noise) {
  const double gain = yawVariance_ / (yawVariance_ + noise);
  box_.yaw = wrapYaw(box_.yaw + gain * (measured - box_.yaw));
  yawVariance_ *= 1.0 - gain;
}

}  // namespace toss
