// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <toss/rawlog/FilteredRawlogWriter.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/RawlogWriter.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "SensorLabels.h"

namespace toss {
namespace {

mrpt::obs::CObservationRobotPose robotPoseOf(const PosedScan& scan) {
  mrpt::obs::CObservationRobotPose observation;
  observation.sensorLabel = kPoseLabel;
  observation.timestamp = toMrptTime(scan.time);
  observation.pose.mean = toMrpt(scan.mapFromSensor * scan.robotFromSensor.inverse());
  return observation;
}

/// A cloud of MRPT that takes its points all at once: MRPT's own setters are two calls for each.
class BulkPoints : public mrpt::maps::CPointsMapXYZI {
 public:
  /// Replaces the points by those of a scan that are in one state.
  void assign(const PointCloud& points, const std::vector<PointState>& states, PointState state) {
    resize(static_cast<std::size_t>(std::count(states.begin(), states.end(), state)));
    if (points.intensity.empty()) std::fill(m_intensity.begin(), m_intensity.end(), 0.0f);
    std::ptrdiff_t place = 0;
    for (auto begin = states.begin(), end = begin; begin != states.end(); begin = end) {
      begin = std::find(end, states.end(), state);
      end = std::find_if(begin, states.end(), [&](PointState each) { return each != state; });
      const auto take = [&](const std::vector<float>& values, auto& kept) {
        if (values.empty()) return;
        std::copy(values.begin() + (begin - states.begin()),
                  values.begin() + (end - states.begin()), kept.begin() + place);
      };
      take(points.x, m_x), take(points.y, m_y), take(points.z, m_z);
      take(points.intensity, m_intensity);
      place += end - begin;
    }
    mark_as_modified();
  }
};

/// What is written of the scans in one state.
struct StateLog {
  PointState state;
  /// Before the ending that tells the LiDAR.
  std::string label;
  /// Kept from scan to scan for its memory.
  std::shared_ptr<BulkPoints> points = std::make_shared<BulkPoints>();
};

}  // namespace

struct FilteredRawlogWriter::Implementation {
  void write(const StateLog& log, const PosedScan& scan, const ScanLabels& labels) {
    mrpt::obs::CObservationPointCloud observation;
    observation.sensorLabel = log.label + endingOf(scan.sensorLabel);
    observation.timestamp = toMrptTime(scan.time);
    observation.sensorPose = toMrpt(scan.robotFromSensor);
    log.points->assign(scan.points, labels.state, log.state);
    observation.pointcloud = log.points;
    writer.write(observation);
  }

  std::string endingOf(const std::string& label) {
    if (!firstLabel) firstLabel = label;
    return label == *firstLabel ? "" : "_" + label;
  }

  RawlogWriter writer;
  /// Label of the LiDAR of the first scan.
  std::optional<std::string> firstLabel{};
  const StateLog logs[2] = {{PointState::Static, "LIDAR_STATIC"},
                            {PointState::Moving, "LIDAR_MOVING"}};
};

FilteredRawlogWriter::FilteredRawlogWriter(const std::filesystem::path& file,
                                           Compression compression)
    : implementation_(new Implementation{RawlogWriter(file, compression == Compression::Gz)}) {}

FilteredRawlogWriter::~FilteredRawlogWriter() = default;

void FilteredRawlogWriter::add(const PosedScan& scan, const ScanLabels& labels) {
  if (labels.scan != scan.index || labels.state.size() != scan.points.size())
    throw std::logic_error("FilteredRawlogWriter::add: the labels are not those of the scan");
  implementation_->writer.write(robotPoseOf(scan));
  for (const StateLog& log : implementation_->logs) implementation_->write(log, scan, labels);
}

void FilteredRawlogWriter::finish() {
  implementation_->writer.commit();
}

}  // namespace toss
