// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ObservationPoints.h>
#include <toss/rawlog/SensorRecognition.h>
#include <toss/rawlog/SweepFolder.h>

#include <algorithm>
#include <map>
#include <utility>

#include "RawlogPoses.h"
#include "RawlogReader.h"
#include "SummaryParts.h"

namespace toss {
namespace {

using mrpt::obs::CObservation;
using Ticks = PoseBuffer::Ticks;

/// Looks at the objects of a rawlog one by one.
class RawlogSurvey {
 public:
  RawlogSurvey(const InputOptions& options, InputSummary& summary)
      : reader_(summary.path), sweeps_(summary.path), poses_(options), summary_(summary) {
    poses_.takeGps(summary.path);
  }

  void run() {
    std::uint64_t objects = 0;
    try {
      while (const auto object = reader_.next()) {
        look(object);
        ++objects;
      }
    } catch (const UserError& error) {
      if (objects == 0) throw;
      summary_.warnings.push_back(error.what());
    }
    finish();
  }

 private:
  void look(const mrpt::serialization::CSerializable::Ptr& object) {
    if (const auto observation = std::dynamic_pointer_cast<CObservation>(object))
      look(*observation);
    else if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
      for (const auto& entry : *frame) {
        if (entry) look(*entry);
      }
    else if (const auto actions = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(object))
      poses_.take(*actions);
  }

  void look(CObservation& observation) {
    const std::string className = observation.GetRuntimeClass()->className;
    StreamSummary& stream = streams_[{className, observation.sensorLabel}];
    const double time = fromMrptTime(observation.timestamp);
    stream.firstTime = stream.count == 0 ? time : std::min(stream.firstTime, time);
    stream.lastTime = stream.count == 0 ? time : std::max(stream.lastTime, time);
    stream.label = observation.sensorLabel;
    stream.className = className;
    ++stream.count;
    if (poses_.take(observation) || !holdsPoints(observation)) return;
    lookAtPoints(observation, stream);
  }

  void lookAtPoints(CObservation& observation, StreamSummary& stream) {
    const Ticks time = observation.timestamp.time_since_epoch().count();
    poses_.placeScan(stream.count - 1, time);
    scanTimes_.push_back(time);
    if (!readPointsOf(observation)) return;
    const std::uint64_t points = scan_.points.size();
    stream.fewestPoints = stream.pointClouds ? std::min(stream.fewestPoints, points) : points;
    stream.mostPoints = std::max(stream.mostPoints, points);
    stream.points += points;
    stream.pointClouds = true;
    scan_.sensorLabel = observation.sensorLabel;
    if (stream.sensorModel.empty() && stream.count <= 10)
      stream.sensorModel = modelOf(fromMrptTime(observation.timestamp));
  }

  /// Name of the sensor that made `scan_`: that of its beams, where they are known.
  std::string modelOf(double time) {
    scan_.time = time;
    scan_.beams = nullptr;
    sweeps_.addTo(scan_, scan_.sensorLabel);
    return scan_.beams ? scan_.beams->name : recognizeSensor(scan_);
  }

  /// Faults of single observations do not end the survey; the first is told.
  bool readPointsOf(CObservation& observation) {
    try {
      readPoints(observation, summary_.path, reader_.place(), scan_);
      return true;
    } catch (const UserError& error) {
      if (!toldOfPoints_) summary_.warnings.push_back(error.what());
      toldOfPoints_ = true;
      return false;
    }
  }

  void finish() {
    for (const auto& [key, stream] : streams_) summary_.streams.push_back(stream);
    summary_.scans = scanTimes_.size();
    for (const Ticks time : scanTimes_) summary_.scansWithoutPose += !poses_.at(time).has_value();
    summary_.poses = poses_.count();
    for (const Eigen::Isometry3d& pose : poses_.path()) addPosition(pose.translation(), summary_);
    poses_.appendWarnings(summary_.path.string(), summary_.warnings);
  }

  RawlogReader reader_;
  SweepFolder sweeps_;
  RawlogPoses poses_;
  InputSummary& summary_;
  std::map<std::pair<std::string, std::string>, StreamSummary> streams_;
  std::vector<Ticks> scanTimes_;
  PosedScan scan_;
  bool toldOfPoints_ = false;
};

}  // namespace

void summarizeRawlog(const InputOptions& options, InputSummary& summary) {
  RawlogSurvey(options, summary).run();
}

}  // namespace toss
