// SPDX-License-Identifier: BSD-3-Clause
#include "MappingSession.h"

#include <toss/rawlog/ObservationPoints.h>

namespace toss {
namespace {

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
  if (!plugin.sensorLabel.empty()) sensorLabel_ = plugin.sensorLabel;
  if (!plugin.rawlog.empty()) sweeps_.emplace(plugin.rawlog);
}

bool MappingSession::refuse(const std::string& reason) {
  if (reasonsTold_.insert(reason).second) log_.logStr(mrpt::system::LVL_WARN, reason);
  return true;
}

bool MappingSession::refuses(const mrpt::obs::CObservation& observation) {
  if (!sensorLabel_) sensorLabel_ = observation.sensorLabel;
  if (observation.sensorLabel != *sensorLabel_)
    return refuse("scans of '" + observation.sensorLabel + "' are left out, '" + *sensorLabel_ +
                  "' is used; choose with plugin.sensor_label");
  if (observation.timestamp == INVALID_TIMESTAMP)
    return refuse("scans without a time stamp are left out");
  if (lastTime_ && observation.timestamp <= *lastTime_)
    return refuse("scans that are not later than the one before are left out");
  return false;
}

void MappingSession::start() {
  SensorChoice sensor;
  if (const std::string& wanted = configuration_.sensor.model; wanted != "auto")
    sensor = {sensorByName(wanted), wanted, wanted};
  else
    sensor = chooseSensor(scan_);
  configuration_ = options_.resolve(sensor.preset);
  pipeline_ = std::make_unique<Pipeline>(configuration_.pipeline, sensor.model);
}

bool MappingSession::insert(const mrpt::obs::CObservation& observation,
                            const Eigen::Isometry3d& mapFromRobot) {
  if (refuses(observation)) return false;
  readObservation(observation, configuration_.plugin.rawlog, scan_);
  if (scan_.points.empty() && !pipeline_) return false;
  placeScan(observation, mapFromRobot, placeOf(observation), scan_);
  if (sweeps_) sweeps_->addTo(scan_, observation.sensorLabel);
  if (!pipeline_) start();
  pipeline_->process(scan_);
  pipeline_->takeSettled();
  lastTime_ = observation.timestamp;
  ++scan_.index;
  return true;
}

std::vector<MapPoint> MappingSession::presentMap() const {
  if (!pipeline_) return {};
  std::vector<MapPoint> points = pipeline_->staticMap();
  const std::vector<MapPoint> pending = pipeline_->pendingMap();
  points.insert(points.end(), pending.begin(), pending.end());
  return points;
}

std::vector<MapPoint> MappingSession::finish() {
  if (!pipeline_) return {};
  pipeline_->finish();
  return pipeline_->staticMap();
}

}  // namespace toss
