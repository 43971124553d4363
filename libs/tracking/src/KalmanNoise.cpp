// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/KalmanNoise.h>

namespace toss {
namespace {

/// F, H, Q, R and P0 of AB3DMOT, which Auto-MOS shares (spec section 5.1).
KalmanNoise paperNoise() {
  KalmanNoise noise;
  noise.step = 1.0;
  noise.position = noise.size = noise.yaw = 1.0;
  noise.velocity = 0.01;
  noise.measuredPosition = noise.measuredSize = noise.measuredYaw = 1.0;
  noise.initialPosition = noise.initialSize = noise.initialYaw = 10.0;
  noise.initialVelocity = 10000.0;
  return noise;
}

double square(double value) {
  return value * value;
}

/// White acceleration held constant within a step (spec section 5.2).
KalmanNoise metricNoise(const KalmanOptions& options, double seconds) {
  const double acceleration = square(options.accelerationSd), tenths = seconds / 0.1;
  KalmanNoise noise;
  noise.step = seconds;
  noise.position = acceleration * square(square(seconds)) / 4.0;
  noise.positionVelocity = acceleration * square(seconds) * seconds / 2.0;
  noise.velocity = acceleration * square(seconds);
  noise.size = square(options.sizeDriftSd) * tenths;
  noise.yaw = square(options.yawDriftSd) * tenths;
  noise.measuredPosition = noise.initialPosition = square(options.positionSd);
  noise.measuredSize = noise.initialSize = square(options.sizeSd);
  noise.measuredYaw = noise.initialYaw = square(options.yawSd);
  noise.initialVelocity = square(options.initialSpeedSd);
  return noise;
}

}  // namespace

KalmanNoise kalmanNoise(const KalmanOptions& options, double seconds) {
  return options.noise == KalmanNoiseModel::Paper ? paperNoise() : metricNoise(options, seconds);
}

}  // namespace toss
