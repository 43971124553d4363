// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/tracking/FaceMotion.h>
#include <toss/tracking/RunningMedian.h>

#include <vector>

namespace toss {

/// What one detection tells about the motion of its trace.
struct MotionObservation {
  /// Time of the scan [s].
  double time = 0.0;
  /// Box after the filter's update and box as measured, map frame.
  Box estimated, measured;
  /// Share of the instance's outline that something nearer hides, 0 to 1.
  double hidden = 0.0;
};

/// Summary of a trace's detections: of its whole life, and of a window of time that moves along.
class MotionEvidence {
 public:
  /// `window`: length of the window [s].
  explicit MotionEvidence(double window) : window_(window) {}

  void add(const MotionObservation& observation);

  /// Detections so far.
  int hits() const { return hits_; }
  /// Largest horizontal distance of the estimated centre from its first place [m].
  double excursion() const { return excursion_; }
  /// Distance between first and last estimated centre in three dimensions [m].
  double displacement3d() const { return (last_ - first_).norm(); }
  /// Length of the estimated centre's horizontal path [m]; steps below 5 cm do not count.
  double pathLength() const { return pathLength_; }
  /// Median of the longer horizontal edge and of the height [m], as measured.
  double medianExtent() const { return extents_.value(); }
  double medianHeight() const { return heights_.value(); }
  /// Longest edge ever measured, vertical ones included [m].
  double longestEdge() const { return longestEdge_; }

  /// Measured boxes within the window, by ascending time.
  const std::vector<TimedBox>& recent() const { return recent_; }
  /// Path length within the window [m].
  double recentPathLength() const { return recent_.empty() ? 0.0 : pathLength_ - pathAt_.front(); }
  /// Mean share of the outline that something nearer hid, over the window.
  double recentHidden() const;

 private:
  void forgetBefore(double time);

  double window_;
  int hits_ = 0;
  double excursion_ = 0.0, pathLength_ = 0.0, longestEdge_ = 0.0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero(), last_ = Eigen::Vector3d::Zero();
  std::vector<TimedBox> recent_;
  /// Path length at each of the recent boxes [m].
  std::vector<double> pathAt_;
  /// Hidden share of each of the recent boxes.
  std::vector<double> hidden_;
  RunningMedian extents_, heights_;
};

}  // namespace toss
