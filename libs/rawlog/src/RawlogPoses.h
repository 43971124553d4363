// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <toss/rawlog/InputOptions.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "PoseBuffer.h"

namespace toss {

/// Gathers the poses of the robot (map <- robot) from the objects of a rawlog.
class RawlogPoses {
 public:
  using Ticks = PoseBuffer::Ticks;

  explicit RawlogPoses(const InputOptions& options);

  /// Takes the pose out of an observation, if it holds one: CObservationRobotPose, whose sensorPose
  /// is honoured (robot = pose of the tracked point, taken back by its place on the robot); with
  /// PoseSource::Odometry CObservationOdometry. False if the observation is of another kind.
  bool take(const mrpt::obs::CObservation& observation);
  /// Adds up the increments of an action/sensory-frame log (2D and 3D).
  void take(const mrpt::obs::CActionCollection& actions);
  /// With PoseSource::Odometry, gives the sum of the increments to the time of a scan.
  void placeScan(Ticks time);

  /// Pose at the time of a scan, options.timeOffset applied; see PoseBuffer.
  std::optional<Eigen::Isometry3d> at(Ticks scanTime) const;
  std::optional<Eigen::Isometry3d> around(Ticks time) const;
  bool mayStillCome(Ticks scanTime) const;
  bool reaches(Ticks time) const;
  void forgetBefore(Ticks scanTime);
  /// To be told of scans that were skipped, for noticing poses that come too late for them.
  void scanSkipped(Ticks scanTime) { lastSkipped_ = scanTime + offset_; }

  /// All poses that were not forgotten.
  const PoseBuffer& buffer() const { return buffer_; }
  std::uint64_t count() const { return count_; }
  bool sawOdometry() const { return sawOdometry_; }
  bool sawPoses() const { return sawPoses_; }
  /// Time of the first and last pose [ticks]; 0 without poses.
  Ticks firstTime() const { return firstTime_; }
  Ticks lastTime() const { return lastTime_; }
  /// Sentences for the user about poses that were left out or came late.
  void appendWarnings(const std::string& file, std::vector<std::string>& warnings) const;

 private:
  void add(Ticks time, const Eigen::Isometry3d& mapFromRobot);

  InputOptions options_;
  Ticks offset_;
  PoseBuffer buffer_;
  std::optional<std::string> label_;
  std::map<std::string, std::uint64_t> otherLabels_;
  Eigen::Isometry3d odometry_ = Eigen::Isometry3d::Identity();
  bool sawActions_ = false, sawOdometry_ = false, sawPoses_ = false;
  std::uint64_t count_ = 0, unusable_ = 0, late_ = 0;
  Ticks firstTime_ = 0, lastTime_ = 0;
  std::optional<Ticks> lastSkipped_;
};

}  // namespace toss
