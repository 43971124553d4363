// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/FilteredRawlogWriter.h>

#include <algorithm>
#include <stdexcept>

#include "OutputStream.h"

namespace toss {
namespace {

mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix4d matrix = pose.matrix();
  return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(matrix));
}

mrpt::obs::CObservationRobotPose robotPoseOf(const PosedScan& scan) {
  mrpt::obs::CObservationRobotPose observation;
  observation.sensorLabel = "POSE";
  observation.timestamp = mrpt::Clock::fromDouble(scan.time);
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
  Implementation(const std::filesystem::path& path, Compression compression)
      : file(path),
        out(file.temporaryPath(), path.string(),
            compression == Compression::Gz ? OutputStream::Format::Gz
                                           : OutputStream::Format::Plain) {}

  void writeCloud(const PosedScan& scan, const ScanLabels& labels, PointState state,
                  const char* sensorLabel) {
    mrpt::obs::CObservationPointCloud observation;
    observation.sensorLabel = sensorLabel;
    observation.timestamp = mrpt::Clock::fromDouble(scan.time);
    observation.sensorPose = toMrpt(scan.robotFromSensor);
    observation.pointcloud = pointsInState(scan, labels, state);
    mrpt::serialization::archiveFrom(out) << observation;
  }

  AtomicFile file;
  OutputStream out;
};

FilteredRawlogWriter::FilteredRawlogWriter(const std::filesystem::path& file,
                                           Compression compression)
    : implementation_(std::make_unique<Implementation>(file, compression)) {}

FilteredRawlogWriter::~FilteredRawlogWriter() = default;

void FilteredRawlogWriter::add(const PosedScan& scan, const ScanLabels& labels) {
  if (labels.scan != scan.index || labels.state.size() != scan.points.size())
    throw std::logic_error("FilteredRawlogWriter::add: the labels are not those of the scan");
  mrpt::serialization::archiveFrom(implementation_->out) << robotPoseOf(scan);
  implementation_->writeCloud(scan, labels, PointState::Static, "LIDAR_STATIC");
  implementation_->writeCloud(scan, labels, PointState::Moving, "LIDAR_MOVING");
}

void FilteredRawlogWriter::finish() {
  implementation_->out.close();
  implementation_->file.commit();
}

}  // namespace toss
