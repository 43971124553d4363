// SPDX-License-Identifier: BSD-3-Clause
#include "MappingSession.h"

#include <toss/rawlog/ObservationPoints.h>

#include <algorithm>

namespace toss {
namespace {

/// Two LiDARs can't be nearer to each other [m].
constexpr double kSamePlace = 0.01;

std::string placeOf(const mrpt::obs::CObservation& observation) {
  return "observation '" + observation.sensorLabel + "' of " +
         mrpt::system::dateTimeToString(observation.timestamp);
}

}  // namespace

void readObservation(const mrpt::obs::CObservation& observation, const std::string& rawlog,
                     PosedScan& scan) {
  const std::string place = placeOf(observation);
  if (rawlog.empty()) try {
      observation.load();
    } catch (const std::exception&) {
      throw UserError(place, "its external file can't be read",
                      "name the log in plugin.rawlog, or call mrpt::io::setLazyLoadPathBase()");
    }
  // Decoding packets is no const call of MRPT's, though it leaves them as they are.
  auto& readable = const_cast<mrpt::obs::CObservation&>(observation);
  readPoints(readable, rawlog, place, scan);
  observation.unload();
}

MappingSession::MappingSession(const FilteredMapOptions& options)
    : options_(options), configuration_(options.resolve("")) {
  const PlugInOptions& plugin = configuration_.plugin;
  if (!plugin.rawlog.empty()) sweeps_.emplace(plugin.rawlog);
}

bool MappingSession::refuse(const std::string& reason) {
  if (reasonsTold_.insert(reason).second) log_.logStr(mrpt::system::LVL_WARN, reason);
  return true;
}

MappingSession::Lidar* MappingSession::lidarOf(const mrpt::obs::CObservation& observation) {
  const std::string& label = observation.sensorLabel;
  const auto found = std::find_if(lidars_.begin(), lidars_.end(),
                                  [&](const Lidar& lidar) { return lidar.label == label; });
  if (found != lidars_.end()) return &*found;
  const std::string& wanted = configuration_.plugin.sensorLabel;
  if (!wanted.empty() && label != wanted) {
    refuse("scans of '" + label + "' are left out, '" + wanted +
           "' is used; choose with plugin.sensor_label");
    return nullptr;
  }
  mrpt::poses::CPose3D place;
  observation.getSensorPose(place);
  for (const Lidar& lidar : lidars_)
    if (place.distanceTo(lidar.place) < kSamePlace) {
      refuse("scans of '" + label + "' are left out, it sits where '" + lidar.label +
             "' does; choose with plugin.sensor_label");
      return nullptr;
    }
  lidars_.push_back({label, place});
  return &lidars_.back();
}

bool MappingSession::refuses(const mrpt::obs::CObservation& observation) {
  if (observation.timestamp == INVALID_TIMESTAMP)
    return refuse("scans without a time stamp are left out");
  const Lidar* lidar = lidarOf(observation);
  if (lidar == nullptr) return true;
  if (lidar->lastTime && observation.timestamp <= *lidar->lastTime)
    return refuse("scans that are not later than the one before are left out");
  return false;
}

void MappingSession::addLidar() {
  SensorChoice sensor;
  if (const std::string& wanted = configuration_.sensor.model; wanted != "auto")
    sensor = {sensorByName(wanted), wanted, wanted};
  else
    sensor = chooseSensor(scan_);
  pipeline_.add(scan_.sensorLabel, options_.resolve(sensor.preset).pipeline, sensor.model);
}

bool MappingSession::insert(const mrpt::obs::CObservation& observation,
                            const Eigen::Isometry3d& mapFromRobot) {
  if (refuses(observation)) return false;
  readObservation(observation, configuration_.plugin.rawlog, scan_);
  if (scan_.points.empty() && !pipeline_.has(observation.sensorLabel)) return false;
  placeScan(observation, mapFromRobot, placeOf(observation), scan_);
  if (sweeps_) sweeps_->addTo(scan_, observation.sensorLabel);
  if (!pipeline_.has(scan_.sensorLabel)) addLidar();
  pipeline_.process(scan_);
  pipeline_.takeSettled();
  lidarOf(observation)->lastTime = observation.timestamp;
  ++scan_.index;
  return true;
}

std::vector<MapPoint> MappingSession::presentMap() const {
  std::vector<MapPoint> points = pipeline_.staticMap();
  const std::vector<MapPoint> pending = pipeline_.pendingMap();
  points.insert(points.end(), pending.begin(), pending.end());
  return points;
}

std::vector<MapPoint> MappingSession::finish() {
  pipeline_.finish();
  return pipeline_.staticMap();
}

}  // namespace toss
