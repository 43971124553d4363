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

mrpt::maps::CPointsMapXYZI::Ptr pointsInState(const PosedScan& scan, const ScanLabels& labels,
                                              PointState state) {
  const PointCloud& points = scan.points;
  auto cloud = mrpt::maps::CPointsMapXYZI::Create();
  cloud->setSize(
      static_cast<std::size_t>(std::count(labels.state.begin(), labels.state.end(), state)));
  std::size_t row = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels.state[i] != state) continue;
    cloud->setPointFast(row, points.x[i], points.y[i], points.z[i]);
    cloud->setPointColor_fast(row, points.intensity.empty() ? 0.0f : points.intensity[i], 0, 0);
    ++row;
  }
  return cloud;
}

}  // namespace

struct FilteredRawlogWriter::Implementation {
  void writeCloud(const PosedScan& scan, const ScanLabels& labels, PointState state,
                  const std::string& sensorLabel) {
    mrpt::obs::CObservationPointCloud observation;
    observation.sensorLabel = sensorLabel;
    observation.timestamp = toMrptTime(scan.time);
    observation.sensorPose = toMrpt(scan.robotFromSensor);
    observation.pointcloud = pointsInState(scan, labels, state);
    writer.write(observation);
  }

  std::string endingOf(const std::string& label) {
    if (!firstLabel) firstLabel = label;
    return label == *firstLabel ? "" : "_" + label;
  }

  RawlogWriter writer;
  /// Label of the LiDAR of the first scan.
  std::optional<std::string> firstLabel{};
};

FilteredRawlogWriter::FilteredRawlogWriter(const std::filesystem::path& file,
                                           Compression compression)
    : implementation_(new Implementation{RawlogWriter(file, compression == Compression::Gz)}) {}

FilteredRawlogWriter::~FilteredRawlogWriter() = default;

void FilteredRawlogWriter::add(const PosedScan& scan, const ScanLabels& labels) {
  if (labels.scan != scan.index || labels.state.size() != scan.points.size())
    throw std::logic_error("FilteredRawlogWriter::add: the labels are not those of the scan");
  implementation_->writer.write(robotPoseOf(scan));
  const std::string ending = implementation_->endingOf(scan.sensorLabel);
  implementation_->writeCloud(scan, labels, PointState::Static, "LIDAR_STATIC" + ending);
  implementation_->writeCloud(scan, labels, PointState::Moving, "LIDAR_MOVING" + ending);
}

void FilteredRawlogWriter::finish() {
  implementation_->writer.commit();
}

}  // namespace toss
