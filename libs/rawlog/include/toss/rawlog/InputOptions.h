// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

#include <string>
#include <vector>

namespace toss {

/// Where the poses of a rawlog come from.
enum class PoseSource {
  Observations,  ///< CObservationRobotPose: poses in 6D
  Odometry,      ///< CObservationOdometry, or the increments of an action/sensory-frame log
  Gps            ///< CObservationGPS: positions, level, headed along the path
};

/// What is done about the motion of the sensor while it sweeps.
enum class Deskew {
  Auto,  ///< compensated where returns have times, poses lie around the sweep, and it is not yet
  Off,   ///< never
  Sweep  ///< as Auto, and where returns have no times, they are those of a sweep as InputOptions
         ///< says
};

/// Sense in which a LiDAR turns, seen from above.
enum class SweepSense {
  Clockwise,        ///< Velodyne, Ouster
  Counterclockwise  ///< others
};

/// What the poses of a pose file are of.
enum class PoseSubject {
  Automatic,  ///< the camera for a file in KITTI format where the folder has calib.txt, else sensor
  Sensor,     ///< the LiDAR
  Robot,      ///< the robot (base_link): the sensor's pose on it comes from the log
  Camera      ///< KITTI's camera: needs calib.txt
};

/// How inputs are read. Section "input".
struct InputOptions : Options {
  /// Label of the sensor whose scans are read; "" = the first one met (toss map: all LiDARs, see
  /// LidarSelection).
  std::string sensorLabel;
  /// Labels of several sensors whose scans are read, in place of sensorLabel; the first is the one
  /// whose poses a pose file holds. Empty = sensorLabel. No option of users.
  std::vector<std::string> sensorLabels;
  /// Label of the pose observations that are used; "" = the first one met.
  std::string poseLabel;
  PoseSource poseSource = PoseSource::Observations;
  /// File with poses in TUM or KITTI format (see PoseFile) that replace those of the input; "" =
  /// none.
  std::string poseFile;
  /// What the poses of poseFile are of.
  PoseSubject poseOf = PoseSubject::Automatic;
  /// A scan between two poses is used only if both are at most this far away in time [s].
  double maxPoseGap = 0.1;
  /// Added to the time stamp of a scan before its pose is looked up [s].
  double timeOffset = 0.0;
  /// Scans that may wait for a pose which comes later in the log.
  int lookAhead = 64;
  /// Time between scans of a KITTI folder that has no times.txt [s].
  double scanPeriod = 0.1;
  /// Gives every scan the identity for a pose, whatever poses there are: for programs that find the
  /// poses themselves. No option of users.
  bool withoutPoses = false;

  /// Compensation of the sensor's motion during a sweep.
  Deskew deskew = Deskew::Auto;
  /// The sweep that Deskew::Sweep takes for granted where returns have no times: turns of the
  /// sensor per second [Hz], sense of rotation seen from above, azimuth at which a sweep begins
  /// [degrees, counterclockwise from the sensor's x axis], and where in the sweep the time stamp
  /// of a scan lies, as a share of it.
  double sweepRate = 10.0;
  SweepSense sweepSense = SweepSense::Clockwise;
  double sweepStart = 180.0;
  double sweepStamp = 0.5;

  const char* section() const override { return "input"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
