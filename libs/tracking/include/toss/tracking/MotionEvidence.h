// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <vector>

namespace toss {

/// What one detection tells about the motion of its trace.
struct MotionObservation {
  /// Time of the scan [s].
  double time = 0.0;
  /// Box after the filter's update and box as measured, map frame.
  Box estimated, measured;
  /// Horizontal distance [m] of the measured centre from its prediction.
  double innovation = 0.0;
  /// Standard deviation of the estimated centre [m].
  double positionSd = 0.0;
};

/// Running summary of a trace's detections, constant work each but for the median.
class MotionEvidence {
 public:
  void add(const MotionObservation& observation);

  /// Detections so far.
  int hits() const { return hits_; }
  /// Time from the first to the last detection [s].
  double age() const { return lastTime_ - firstTime_; }
  /// Largest horizontal distance of the estimated centre from its first place [m].
  double excursion() const { return excursion_; }
  /// Horizontal distance of the last estimated centre from the first [m].
  double displacement() const;
  /// Length of the horizontal path [m]; steps below 5 cm do not count.
  double pathLength() const { return pathLength_; }
  /// Median of the longer horizontal edge [m].
  double medianExtent() const;
  /// Longest edge ever measured, vertical ones included [m].
  double longestEdge() const { return longestEdge_; }
  /// Distance between first and last estimated centre in three dimensions [m].
  double displacement3d() const { return (last_ - first_).norm(); }
  /// Standard deviation of the last centre [m].
  double jitter() const { return jitter_; }
  /// How far the lagging one of front and rear face has moved in the direction of the displacement
  /// since the first detection [m]; negative where it has moved backwards.
  double faceDisplacement() const;

 private:
  int hits_ = 0;
  double firstTime_ = 0.0, lastTime_ = 0.0;
  double excursion_ = 0.0, pathLength_ = 0.0, longestEdge_ = 0.0, jitter_ = 0.0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero(), last_ = Eigen::Vector3d::Zero();
  Box firstMeasured_, lastMeasured_;
  /// Ascending.
  std::vector<float> extents_;
};

}  // namespace toss
