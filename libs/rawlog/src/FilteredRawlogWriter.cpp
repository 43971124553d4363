// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <toss/rawlog/FilteredRawlogWriter.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/RawlogWriter.h>

#include <algorithm>
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

void takePoints(const PosedScan& scan, const ScanLabels& labels, PointState state,
                mrpt::maps::CPointsMapXYZI& cloud) {
  const PointCloud& points = scan.points;
  cloud.setSize(
      static_cast<std::size_t>(std::count(labels.state.begin(), labels.state.end(), state)));
  std::size_t row = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels.state[i] != state) continue;
    cloud.setPointFast(row, points.x[i], points.y[i], points.z[i]);
    cloud.setPointColor_fast(row, points.intensity.empty() ? 0.0f : points.intensity[i], 0, 0);
    ++row;
  }
}

/// What is written of the scans in one state.
struct StateLog {
  PointState state;
  /// Before the ending that tells the LiDAR.
  std::string label;
  /// Kept from scan to scan for its memory.
  mrpt::maps::CPointsMapXYZI::Ptr points = mrpt::maps::CPointsMapXYZI::Create();
};

}  // namespace

struct FilteredRawlogWriter::Implementation {
  void write(const StateLog& log, const PosedScan& scan, const ScanLabels& labels) {
    mrpt::obs::CObservationPointCloud observation;
    observation.sensorLabel = log.label + endingOf(scan.sensorLabel);
    observation.timestamp = toMrptTime(scan.time);
    observation.sensorPose = toMrpt(scan.robotFromSensor);
    takePoints(scan, labels, log.state, *log.points);
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
