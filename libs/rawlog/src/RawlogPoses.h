// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <toss/rawlog/InputOptions.h>
#include <toss/rawlog/PoseFile.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "PoseBuffer.h"

namespace toss {

/// Gathers the poses of the robot (map <- robot) from the objects of a rawlog, or takes them from
/// options.poseFile instead.
class RawlogPoses {
 public:
  using Ticks = PoseBuffer::Ticks;

  /// Throws UserError where options.poseFile can't be read, or holds poses of a camera: a rawlog
  /// has no calibration for it.
  explicit RawlogPoses(const InputOptions& options);

  /// With PoseSource::Gps takes the poses from the positions in the rawlog, all at once. Throws
  /// UserError where there are none, or they tell no course.
  void takeGps(const std::filesystem::path& rawlog);
  /// Takes the pose out of an observation, if it holds one: CObservationRobotPose, whose sensorPose
  /// is honoured (robot = pose of the tracked point, taken back by its place on the robot); with
  /// PoseSource::Odometry CObservationOdometry. False if the observation is of another kind.
  bool take(const mrpt::obs::CObservation& observation);
  /// Adds up the increments of an action/sensory-frame log (2D and 3D).
  void take(const mrpt::obs::CActionCollection& actions);
  /// To be told of each scan of the sensor, by its number: with PoseSource::Odometry gives the sum
  /// of the increments to its time, and with a pose file in KITTI format the row of that number.
  void placeScan(std::uint64_t index, Ticks time);

  /// Pose at the time of a scan, options.timeOffset applied; see PoseBuffer. The identity with
  /// options.withoutPoses.
  std::optional<Eigen::Isometry3d> at(Ticks scanTime) const;
  std::optional<Eigen::Isometry3d> around(Ticks time) const;
  /// Whether these poses are of the sensor, not of the robot.
  bool ofSensor() const { return options_.withoutPoses || (file_ && !fileOfRobot()); }
  bool mayStillCome(Ticks scanTime) const;
  bool reaches(Ticks time) const;
  void forgetBefore(Ticks scanTime);
  /// To be told of scans that were skipped, for noticing poses that come too late for them.
  void scanSkipped(Ticks scanTime) { lastSkipped_ = scanTime + offset_; }

  /// All poses that were not forgotten, in order of time.
  std::vector<Eigen::Isometry3d> path() const;
  std::uint64_t count() const { return count_; }
  bool sawOdometry() const { return sawOdometry_; }
  bool sawPoses() const { return sawPoses_; }
  bool sawGps() const { return sawGps_; }
  /// Time of the first and last pose [ticks]; 0 without poses.
  Ticks firstTime() const { return firstTime_; }
  Ticks lastTime() const { return lastTime_; }
  /// Sentences for the user about poses that were left out or came late.
  void appendWarnings(const std::string& file, std::vector<std::string>& warnings) const;

 private:
  void add(Ticks time, const Eigen::Isometry3d& mapFromRobot);
  bool fromGps() const { return options_.poseSource == PoseSource::Gps && !file_; }
  bool fileOfRobot() const { return options_.poseOf == PoseSubject::Robot; }

  InputOptions options_;
  std::optional<PoseFile> file_;
  Ticks offset_;
  PoseBuffer buffer_;
  std::optional<std::string> label_;
  std::map<std::string, std::uint64_t> otherLabels_;
  Eigen::Isometry3d odometry_ = Eigen::Isometry3d::Identity();
  bool sawActions_ = false, sawOdometry_ = false, sawPoses_ = false, sawGps_ = false;
  std::uint64_t count_ = 0, unusable_ = 0, late_ = 0;
  Ticks firstTime_ = 0, lastTime_ = 0;
  std::optional<Ticks> lastSkipped_;
};

}  // namespace toss
