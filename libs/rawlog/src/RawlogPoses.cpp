// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogPoses.h"

#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>

#include <algorithm>
#include <cmath>

#include "GpsPath.h"

namespace toss {
namespace {

using Ticks = RawlogPoses::Ticks;

constexpr Ticks kNoTime = 0;

Ticks toTicks(double seconds) {
  return std::llround(seconds * 1e7);
}

Ticks ticksOf(const mrpt::obs::CObservation& observation) {
  return observation.timestamp.time_since_epoch().count();
}

Eigen::Isometry3d robotPose(const mrpt::obs::CObservationRobotPose& observation) {
  const Eigen::Isometry3d mapFromPoint = fromMrpt(observation.pose.mean);
  const Eigen::Isometry3d robotFromPoint = fromMrpt(observation.sensorPose);
  // Without an offset nothing is multiplied, so that the bits stay.
  if (robotFromPoint.matrix() == Eigen::Matrix4d::Identity()) return mapFromPoint;
  return mapFromPoint * robotFromPoint.inverse();
}

std::string counted(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " of '" + name + "'";
  return text;
}

}  // namespace

RawlogPoses::RawlogPoses(const InputOptions& options)
    : options_(options),
      offset_(toTicks(options.timeOffset)),
      buffer_(toTicks(options.maxPoseGap)) {
  if (!options.poseLabel.empty()) label_ = options.poseLabel;
  if (options.poseFile.empty() || options.withoutPoses) return;
  if (options.poseOf == PoseSubject::Camera)
    throw UserError("input.pose_of=camera", "a rawlog has no calibration of a camera",
                    "give a KITTI folder with calib.txt, or poses of the LiDAR or the robot");
  file_.emplace(options.poseFile, options.maxPoseGap);
  for (std::size_t i = 0; i < file_->times().size(); ++i)
    add(toMrptTime(file_->times()[i]).time_since_epoch().count(), file_->poses()[i]);
}

void RawlogPoses::add(Ticks time, const Eigen::Isometry3d& mapFromRobot) {
  if (!isRigid(mapFromRobot) || time == kNoTime) {
    ++unusable_;
    return;
  }
  firstTime_ = count_ == 0 ? time : std::min(firstTime_, time);
  lastTime_ = count_ == 0 ? time : std::max(lastTime_, time);
  ++count_;
  late_ += lastSkipped_ && time <= *lastSkipped_;
  buffer_.add(time, mapFromRobot);
}

void RawlogPoses::takeGps(const std::filesystem::path& rawlog) {
  if (!fromGps() || options_.withoutPoses) return;
  const char* remedy = "find poses with --odometry, or give them with --poses FILE";
  const std::vector<GpsFix> fixes = readGpsFixes(rawlog);
  if (fixes.empty())
    throw UserError(rawlog.string(), "holds no CObservationGPS with a position (GGA, RMC)", remedy);
  const auto poses = posesAlong(fixes);
  if (poses.empty())
    throw UserError(rawlog.string(),
                    "its GPS positions cover less than 6 m of way: no heading can be told", remedy);
  for (const auto& [time, mapFromRobot] : poses) add(time, mapFromRobot);
}

bool RawlogPoses::take(const mrpt::obs::CObservation& observation) {
  const bool odometry = options_.poseSource == PoseSource::Odometry;
  if (const auto* pose = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation)) {
    sawPoses_ = true;
    if (odometry || file_ || fromGps()) return true;
    if (!label_) label_ = pose->sensorLabel;
    if (pose->sensorLabel == *label_)
      add(ticksOf(observation), robotPose(*pose));
    else
      ++otherLabels_[pose->sensorLabel];
    return true;
  }
  if (const auto* wheels = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation)) {
    sawOdometry_ = true;
    if (odometry && !file_)
      add(ticksOf(observation), fromMrpt(mrpt::poses::CPose3D(wheels->odometry)));
    return true;
  }
  if (dynamic_cast<const mrpt::obs::CObservationGPS*>(&observation) != nullptr) sawGps_ = true;
  return false;
}

void RawlogPoses::take(const mrpt::obs::CActionCollection& actions) {
  for (const auto& action : actions) {
    mrpt::poses::CPose3D increment;
    if (const auto* in3d =
            dynamic_cast<const mrpt::obs::CActionRobotMovement3D*>(action.get_ptr().get()))
      increment = in3d->poseChange.mean;
    else if (const auto* in2d =
                 dynamic_cast<const mrpt::obs::CActionRobotMovement2D*>(action.get_ptr().get()))
      increment = mrpt::poses::CPose3D(in2d->poseChange->getMeanVal());
    else
      continue;
    sawOdometry_ = sawActions_ = true;
    odometry_ = odometry_ * fromMrpt(increment);
    // One estimate per step is enough: collections may hold several of the same movement.
    break;
  }
}

void RawlogPoses::placeScan(std::uint64_t index, Ticks time) {
  if (file_) {
    if (file_->format() == PoseFileFormat::Kitti && index < file_->poses().size())
      add(time + offset_, file_->poses()[index]);
  } else if (options_.poseSource == PoseSource::Odometry && sawActions_) {
    add(time + offset_, odometry_);
  }
}

std::optional<Eigen::Isometry3d> RawlogPoses::at(Ticks scanTime) const {
  if (options_.withoutPoses) return Eigen::Isometry3d::Identity();
  return buffer_.at(scanTime + offset_);
}

std::optional<Eigen::Isometry3d> RawlogPoses::around(Ticks time) const {
  return buffer_.around(time + offset_);
}

bool RawlogPoses::reaches(Ticks time) const {
  return buffer_.reaches(time + offset_);
}

bool RawlogPoses::mayStillCome(Ticks scanTime) const {
  return !file_ && !fromGps() && buffer_.mayStillCome(scanTime + offset_);
}

std::vector<Eigen::Isometry3d> RawlogPoses::path() const {
  std::vector<Eigen::Isometry3d> path;
  for (const auto& [time, pose] : buffer_.all()) path.push_back(pose);
  return path;
}

void RawlogPoses::forgetBefore(Ticks scanTime) {
  buffer_.forgetBefore(scanTime + offset_);
}

void RawlogPoses::appendWarnings(const std::string& file,
                                 std::vector<std::string>& warnings) const {
  if (options_.withoutPoses) return;
  if (file_ && options_.poseOf == PoseSubject::Automatic)
    warnings.push_back(options_.poseFile +
                       ": its poses are taken for those of the LiDAR; say what they are of with "
                       "input.pose_of");
  if (!file_ && options_.poseSource == PoseSource::Odometry && count_ > 0)
    warnings.push_back(file +
                       ": the poses are odometry, which drifts, and from wheels it knows no slopes "
                       "(height, roll and pitch are 0); prefer --odometry or poses from SLAM");
  if (fromGps() && count_ > 0)
    warnings.push_back(file +
                       ": the poses are positions of a satellite receiver, good to metres at best, "
                       "level and headed along the path: expect walls to be smeared, and what "
                       "stands to be taken for moving; prefer --odometry or poses from SLAM");
  if (!otherLabels_.empty())
    warnings.push_back(file + ": poses labelled '" + label_.value_or("") +
                       "' are used, others were left out (" + counted(otherLabels_) +
                       "); choose with input.pose_label");
  if (unusable_ > 0)
    warnings.push_back(
        file + ": " + std::to_string(unusable_) +
        " poses are not finite, no rotation or without a time stamp, and were left out");
  if (late_ > 0)
    warnings.push_back(file + ": " + std::to_string(late_) +
                       " poses come long after the scans of their time; raise input.look_ahead or "
                       "sort the log by time");
}

}  // namespace toss
