// SPDX-License-Identifier: BSD-3-Clause
#include "PoseFinding.h"

#include <toss/geometry/FormatText.h>

#include <cmath>

namespace toss {
namespace {

/// Roll, pitch and yaw [degrees] of a rotation.
Eigen::Vector3d degrees(const Eigen::Matrix3d& r) {
  const Eigen::Vector3d angles(std::atan2(r(2, 1), r(2, 2)),
                               -std::asin(std::clamp(r(2, 0), -1.0, 1.0)),
                               std::atan2(r(1, 0), r(0, 0)));
  return angles * (180.0 / M_PI);
}

Finding displaced(const Eigen::Isometry3d& frame) {
  const Eigen::Vector3d t = frame.translation(), a = degrees(frame.linear());
  return {Severity::Fault, "pose-frame",
          format("the poses are of another frame than the LiDAR's: there it would sit at x %.2f, y "
                 "%.2f, z %.2f m with roll %.0f, pitch %.0f, yaw %.0f degrees",
                 t.x(), t.y(), t.z(), a.x(), a.y(), a.z()),
          "the sensor's pose on the robot is missing or wrong: set sensorPose of the scans' "
          "observations, or input.pose_of"};
}

Finding found(const PoseJudgement& judgement) {
  switch (judgement.fault) {
    case PoseFault::Still:
      return {Severity::Fault, "poses-still", "the poses stand still while the scans move",
              "check where the poses come from, or find them with --odometry"};
    case PoseFault::Inverted:
      return {Severity::Fault, "poses-inverted",
              "the poses are inverted: they map the world into the sensor",
              "invert each pose: map <- sensor is needed"};
    case PoseFault::CameraAxes:
      return {Severity::Fault, "pose-camera",
              "the poses are those of a camera (z ahead, x right, y down), not of the LiDAR",
              "put calib.txt with Tr into the folder, set input.pose_of=camera, or turn the poses "
              "into the LiDAR's: Tr^-1 * P * Tr"};
    case PoseFault::Displaced:
      return displaced(judgement.poseFromSensor);
    case PoseFault::Scale:
      return {Severity::Fault, "pose-scale",
              format("lengths of the poses have to be multiplied by %.4g to fit the scans",
                     judgement.scale),
              "write the poses in metres; a monocular camera knows no scale"};
    case PoseFault::TimeOffset:
      return {Severity::Fault, "pose-time",
              format("the clocks of scans and poses differ by about %.2f s", judgement.timeOffset),
              format("set input.time_offset to its present value plus %.2f", judgement.timeOffset)};
    default:
      return {Severity::Fault, "poses-wrong",
              "consecutive scans do not lie on each other under the poses, and no simple cause "
              "explains it",
              "check where the poses come from, or find them with --odometry"};
  }
}

}  // namespace

void reportPoses(const PoseJudgement& judgement, Findings& findings) {
  if (judgement.fault == PoseFault::None) return;
  if (judgement.fault == PoseFault::Unknown) {
    findings.push_back({Severity::Note, "poses-unjudged",
                        "the sensor hardly moves where it was looked at: whether the poses are "
                        "right does not show",
                        "check a part of the log in which it moves"});
    return;
  }
  Finding finding = found(judgement);
  finding.text += format(
      " (a point 10 m away is put %.2f m wrong after half a second, in which it "
      "moves by %.2f m)",
      judgement.error, judgement.motion);
  findings.push_back(finding);
}

}  // namespace toss
