// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace toss {

/// How far a pose has been from its prediction so far: what the search for correspondences is
/// scaled by (KISS-ICP, section III-C, Eq. 6-8).
class AdaptiveThreshold {
 public:
  /// `initial`: sigma before any motion [m]. `minMotion`: smaller deviations do not count [m].
  /// `maxRange`: range at which a deviation in rotation becomes one in position [m].
  AdaptiveThreshold(double initial, double minMotion, double maxRange);

  /// Takes the deviation prediction^-1 * pose of one scan.
  void add(const Eigen::Isometry3d& deviation);
  /// Root mean square of the deviations [m], each its translation plus the way that its rotation
  /// moves a point at maxRange.
  double sigma() const;

 private:
  double initial_, minMotion_, maxRange_, sumOfSquares_ = 0.0;
  int count_ = 0;
};

}  // namespace toss
