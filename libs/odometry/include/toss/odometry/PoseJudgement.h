// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace toss {

/// What is wrong with poses, as far as the scans tell.
enum class PoseFault {
  None,          ///< they agree with the scans
  Unknown,       ///< the scans moved too little, or their motion could not be found
  Still,         ///< they stand still while the scans move
  Inverted,      ///< sensor <- map instead of map <- sensor
  CameraAxes,    ///< of a camera: z ahead, x right, y down
  Displaced,     ///< of another frame on the same body: it is turned or shifted against the LiDAR
  Scale,         ///< in another unit, or of a monocular camera
  TimeOffset,    ///< of another clock
  Inconsistent,  ///< none of these explains how they contradict the scans
};

/// The motion of a sensor over a stretch of scans, as poses tell it and as the scans do. Each
/// stretch has a map frame of its own; shape [n] each.
struct MotionStretch {
  /// Times [s], ascending.
  std::vector<double> times;
  /// map <- sensor, to be judged.
  std::vector<Eigen::Isometry3d> given;
  /// map <- sensor as LidarOdometry finds it.
  std::vector<Eigen::Isometry3d> found;
  /// How sharply the scans lie on each other under the given and the found poses: sums of MapFit.
  double givenFit = 0.0, foundFit = 0.0;
};

/// The judgement, and the numbers that explain it.
struct PoseJudgement {
  PoseFault fault = PoseFault::Unknown;
  /// Where the poses put a point 10 m away after half a second, less where the scans put it: median
  /// [m]; the same if the fault is mended; and how far such a point moves at all [m].
  double error = 0.0, mendedError = 0.0, motion = 0.0;
  /// givenFit as a share of foundFit: above 1 the poses are better than what was found.
  double fitShare = 1.0;
  /// PoseFault::Displaced: frame of the poses <- LiDAR [m].
  Eigen::Isometry3d poseFromSensor = Eigen::Isometry3d::Identity();
  /// PoseFault::Scale: by what the poses' lengths are to be multiplied.
  double scale = 1.0;
  /// PoseFault::TimeOffset: what is to be added to a scan's time to find its pose [s].
  double timeOffset = 0.0;
};

/// Compares motions over half a second, which do not depend on the map frames and hardly on drift.
/// Poses under which the scans lie on each other about as sharply as under those that were found
/// are right, whatever their motion: the odometry errs where geometry does not hold it. A cause is
/// named only where it explains most of the error. A shift of the frame shows only where the sensor
/// turns, an offset of time only where its velocity changes: where neither shows, neither harms.
PoseJudgement judgePoses(const std::vector<MotionStretch>& stretches);

}  // namespace toss
