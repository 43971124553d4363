// SPDX-License-Identifier: BSD-3-Clause
#include "RawlogSource.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "Deskew.h"
#include "SweepTimes.h"

namespace toss {
namespace {

using mrpt::obs::CObservation;
using Ticks = PoseBuffer::Ticks;

/// Kinds that hold ranges, but not as points: named to the user where nothing else is found.
bool isOtherRangeScan(const CObservation& observation) {
  return IS_CLASS(observation, mrpt::obs::CObservation2DRangeScan) ||
         IS_CLASS(observation, mrpt::obs::CObservation3DRangeScan);
}

/// Returns may be measured before their scan's time stamp [ticks].
constexpr Ticks kLongestSweep = 10'000'000;

Ticks toTicks(double seconds) {
  return std::llround(seconds * 1e7);
}

std::string toText(Ticks time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f s",
                fromMrptTime(mrpt::Clock::time_point(mrpt::Clock::duration(time))));
  return text;
}

std::string listOf(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " of '" + name + "'";
  return text;
}

template <typename Sensors>
std::string labels(const Sensors& sensors) {
  std::string text;
  for (const auto& sensor : sensors) text += (text.empty() ? "'" : ", '") + sensor.label + "'";
  return text;
}

}  // namespace

RawlogSource::RawlogSource(const std::filesystem::path& file, const InputOptions& options)
    : options_(options),
      sweepIsKnown_(options.deskew == Deskew::Sweep),
      reader_(file),
      sweeps_(file),
      poses_(options) {
  for (const std::string& label : options.sensorLabels) sensors_.emplace_back(label);
  if (sensors_.empty() && !options.sensorLabel.empty()) sensors_.emplace_back(options.sensorLabel);
  if (options.withoutPoses) options_.deskew = Deskew::Off;
  poses_.takeGps(file);
}

bool RawlogSource::next(PosedScan& scan) {
  for (;;) {
    if (waiting_.empty()) {
      if (readMore()) continue;
      failAtEnd();
      return false;
    }
    std::optional<Eigen::Isometry3d> pose;
    const Decision decision = decide(waiting_.front(), pose);
    if (decision == Decision::Wait) {
      readMore();
      continue;
    }
    if (decision == Decision::Deliver) {
      if (!loaded_) load(waiting_.front(), *pose, scan);
      loaded_ = true;
      if (sweepGoesOn(waiting_.front(), scan) && readMore()) continue;
      loaded_ = false;
      finish(waiting_.front(), scan);
    } else {
      poses_.scanSkipped(waiting_.front().time);
      ++report_.skippedForPose;
    }
    poses_.forgetBefore(waiting_.front().time - kLongestSweep);
    waiting_.pop_front();
    if (decision == Decision::Deliver) return true;
  }
}

RawlogSource::Decision RawlogSource::decide(const Waiting& front,
                                            std::optional<Eigen::Isometry3d>& pose) const {
  pose = poses_.at(front.time);
  if (pose) return Decision::Deliver;
  const bool full = waiting_.size() > static_cast<std::size_t>(options_.lookAhead);
  return !ended_ && !full && poses_.mayStillCome(front.time) ? Decision::Wait : Decision::Skip;
}

mrpt::serialization::CSerializable::Ptr RawlogSource::readObject() {
  try {
    return reader_.next();
  } catch (const UserError& error) {
    // The scans that lie before the damage come first.
    damage_ = error.what();
    return nullptr;
  }
}

bool RawlogSource::readMore() {
  const auto object = ended_ ? nullptr : readObject();
  ended_ = !object;
  if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
    take(observation);
  else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
    for (const auto& entry : *frame) take(entry);
  else if (const auto actions = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(object))
    poses_.take(*actions);
  return !ended_;
}

void RawlogSource::take(const CObservation::Ptr& observation) {
  if (!observation || poses_.take(*observation)) return;
  if (holdsPoints(*observation))
    takeScan(observation);
  else if (isOtherRangeScan(*observation))
    ++otherRangeScans_[observation->GetRuntimeClass()->className];
}

RawlogSource::Sensor* RawlogSource::sensorOf(const std::string& label) {
  if (sensors_.empty()) sensors_.emplace_back(label);
  const auto found = std::find_if(sensors_.begin(), sensors_.end(),
                                  [&](const Sensor& sensor) { return sensor.label == label; });
  return found == sensors_.end() ? nullptr : &*found;
}

void RawlogSource::takeScan(const CObservation::Ptr& observation) {
  Sensor* const sensor = sensorOf(observation->sensorLabel);
  if (!sensor) {
    ++otherSensors_[observation->sensorLabel];
    ++report_.otherSensors;
    return;
  }
  const std::uint64_t index = nextIndex_++, indexOfSensor = sensor->scans++;
  if (observation->timestamp == INVALID_TIMESTAMP) {
    ++withoutTime_;
    ++report_.skippedForPose;
    return;
  }
  const Ticks time = observation->timestamp.time_since_epoch().count();
  if (sensor->lastTime && time <= *sensor->lastTime) {
    if (report_.skippedForTime++ == 0) firstSkippedForTime_ = reader_.place();
    return;
  }
  sensor->lastTime = lastTime_ = time;
  if (!firstScanTime_) firstScanTime_ = time;
  constexpr auto kNoRow = std::numeric_limits<std::uint64_t>::max();
  poses_.placeScan(sensor == &sensors_.front() ? indexOfSensor : kNoRow, time);
  if (sensors_.size() > 1 && !sensor->robotFromSensor) {
    mrpt::poses::CPose3D onRobot;
    observation->getSensorPose(onRobot);
    sensor->robotFromSensor = fromMrpt(onRobot);
  }
  waiting_.push_back({observation, sensor, index, time, reader_.place()});
}

/// Poses of a sensor are those of the first one. Nothing where they are of this one.
std::optional<Eigen::Isometry3d> RawlogSource::poseFromSensor(const Sensor& sensor,
                                                              const PosedScan& scan) const {
  if (!poses_.ofSensor()) return scan.robotFromSensor;
  const Sensor& posed = sensors_.front();
  if (&sensor == &posed || !posed.robotFromSensor) return std::nullopt;
  return posed.robotFromSensor->inverse() * scan.robotFromSensor;
}

void RawlogSource::load(const Waiting& from, const Eigen::Isometry3d& pose, PosedScan& scan) {
  readPoints(*from.observation, reader_.file(), from.place, scan);
  placeScan(*from.observation, pose, from.place, scan);
  if (poses_.ofSensor()) {
    const auto offset = poseFromSensor(*from.sensor, scan);
    scan.mapFromSensor = offset ? pose * *offset : pose;
  }
  scan.index = from.index;
  const bool fromPackets = !scan.points.ring.empty();
  if (!fromPackets && !sweeps_.addTo(scan, from.observation->sensorLabel)) ++withoutSweep_;
  if (sweepIsKnown_ && scan.points.time.empty() && !scan.motionCompensated)
    setSweepTimes(options_, scan.points);
  scan.sensorModel = from.sensor->model.modelOf(scan);
  countScan(scan.points, report_);
}

/// Poses later in the log still belong to the sweep.
bool RawlogSource::sweepGoesOn(const Waiting& from, const PosedScan& scan) const {
  if (options_.deskew == Deskew::Off || scan.motionCompensated || scan.points.time.empty())
    return false;
  const bool full = waiting_.size() > static_cast<std::size_t>(options_.lookAhead);
  return !ended_ && !full &&
         !poses_.reaches(from.time + toTicks(static_cast<double>(sweepEnd(scan.points))));
}

void RawlogSource::finish(const Waiting& from, PosedScan& scan) {
  if (options_.deskew == Deskew::Off || scan.motionCompensated || scan.points.time.empty()) return;
  const auto offset = poseFromSensor(*from.sensor, scan);
  const bool done = deskew(poses_, offset ? &*offset : nullptr, from.time, scan);
  ++(done ? report_.deskewed : report_.notDeskewed);
}

void RawlogSource::failAtEnd() const {
  if (!damage_.empty())
    throw UserError(damage_ + " (" + std::to_string(report_.scans) + " scans lie before it)");
  if (report_.scans == 0) failWithoutScans();
}

void RawlogSource::failWithoutScans() const {
  const std::string file = reader_.file().string();
  if (nextIndex_ == 0 && !otherSensors_.empty())
    throw UserError(file,
                    "holds no point cloud of sensor '" + sensors_.front().label + "', but " +
                        listOf(otherSensors_),
                    "set input.sensor_label to one of these");
  if (nextIndex_ == 0)
    throw UserError(
        file,
        "holds no point cloud" +
            (otherRangeScans_.empty() ? std::string() : ", only " + listOf(otherRangeScans_)),
        "give a log with CObservationPointCloud or CObservationVelodyneScan");
  if (poses_.count() == 0 && poses_.sawOdometry() && !poses_.sawPoses())
    throw UserError(file, "holds no poses of the robot, only odometry",
                    "give poses with --poses FILE, find them with --odometry, or set "
                    "input.pose_source=odometry");
  if (poses_.count() == 0)
    throw UserError(
        file,
        "holds no poses of the robot that can be used" +
            std::string(poses_.sawGps() ? ", only GPS positions" : ""),
        "give poses with --poses FILE, or find them with --odometry; see " +
            std::string(poses_.sawGps() ? "input.pose_source=gps" : "input.pose_label") + " too");
  if (!firstScanTime_)
    throw UserError(file, "none of its scans has a time stamp", "record the log again");
  throw UserError(file,
                  "no scan has a pose near enough in time: scans from " + toText(*firstScanTime_) +
                      " to " + toText(*lastTime_) + ", poses from " + toText(poses_.firstTime()) +
                      " to " + toText(poses_.lastTime()),
                  "set input.time_offset if the clocks differ, or raise input.max_pose_gap");
}

const InputReport& RawlogSource::report() const {
  const std::string file = reader_.file().string();
  report_.warnings.clear();
  const auto warn = [&](const std::string& text) {
    report_.warnings.push_back(file + ": " + text);
  };
  const std::uint64_t noPose = report_.skippedForPose - withoutTime_;
  if (noPose > 0)
    warn(std::to_string(noPose) + " scans were skipped, no pose lies within " +
         std::to_string(options_.maxPoseGap) + " s before and after them (input.max_pose_gap)");
  if (withoutTime_ > 0)
    warn(std::to_string(withoutTime_) + " scans were skipped, they have no time stamp");
  if (report_.notDeskewed > 0)
    warn(std::to_string(report_.notDeskewed) +
         " scans could not be compensated for the sensor's motion, two poses around them are "
         "needed (input.max_pose_gap, input.deskew)");
  if (withoutSweep_ > 0)
    warn(std::to_string(withoutSweep_) +
         " scans have no rings and times, although the log has a folder of them; copy the folder "
         "<stem>_sweeps again");
  if (report_.skippedForTime > 0)
    warn(std::to_string(report_.skippedForTime) +
         " scans were skipped, they are not later than the one before, first at " +
         firstSkippedForTime_ + "; cut the log there and map the parts apart");
  if (!otherSensors_.empty())
    warn("scans labelled " + labels(sensors_) + " are used, others were left out (" +
         listOf(otherSensors_) + "); choose with input.sensor_label");
  if (!otherRangeScans_.empty()) warn("left out, they hold no points: " + listOf(otherRangeScans_));
  poses_.appendWarnings(file, report_.warnings);
  return report_;
}

}  // namespace toss
