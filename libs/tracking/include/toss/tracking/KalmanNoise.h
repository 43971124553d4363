// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/TrackingOptions.h>

namespace toss {

/// Variances of the box filter for one time step (spec sections 5.1 and 5.2). Every axis has the
/// same. Lengths in m, times in units of the step: seconds (Metric) or scans (Paper).
struct KalmanNoise {
  /// Length of the step: seconds, or 1 scan.
  double step = 0.0;
  /// Process noise added within the step: position, position with velocity, velocity.
  double position = 0.0, positionVelocity = 0.0, velocity = 0.0;
  /// Process noise added within the step: each extent, yaw.
  double size = 0.0, yaw = 0.0;
  /// Measurement noise: each centre coordinate, each extent, yaw.
  double measuredPosition = 0.0, measuredSize = 0.0, measuredYaw = 0.0;
  /// Variances of a trace that has been seen once.
  double initialPosition = 0.0, initialVelocity = 0.0, initialSize = 0.0, initialYaw = 0.0;
};

/// The noise for a step of `seconds` [s]. Paper: AB3DMOT's matrices, independent of `seconds`.
KalmanNoise kalmanNoise(const KalmanOptions& options, double seconds);

}  // namespace toss
