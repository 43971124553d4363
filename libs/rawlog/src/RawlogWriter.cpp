// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/AtomicFolder.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/RawlogWriter.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/rawlog/SweepFolder.h>

#include <stdexcept>
#include <system_error>

#include "OutputStream.h"
#include "SensorLabels.h"

namespace toss {
namespace {

Eigen::Isometry3d mapFromRobot(const PosedScan& scan) {
  // Without a sensor pose nothing is multiplied, so that the bits stay.
  if (scan.robotFromSensor.matrix() == Eigen::Matrix4d::Identity()) return scan.mapFromSensor;
  return scan.mapFromSensor * scan.robotFromSensor.inverse();
}

mrpt::maps::CPointsMapXYZI::Ptr toPointsMap(const PointCloud& points) {
  auto map = mrpt::maps::CPointsMapXYZI::Create();
  map->setAllPoints(points.x, points.y, points.z);
  for (std::size_t i = 0; i < points.size(); ++i)
    map->setPointColor_fast(i, points.intensity.empty() ? 0.0f : points.intensity[i], 0, 0);
  return map;
}

}  // namespace

struct RawlogWriter::Implementation {
  Implementation(const std::filesystem::path& path, bool gz)
      : finalPath(path),
        file(path),
        out(file.temporaryPath(), path.string(),
            gz ? OutputStream::Format::Gz : OutputStream::Format::Plain) {}

  /// Folders of another log beside this one would be taken for its own.
  void checkNoForeignFolders() const {
    const auto check = [](const std::filesystem::path& folder, const char* what) {
      std::error_code ignored;
      if (std::filesystem::exists(folder, ignored))
        throw UserError(folder.string(),
                        "holds " + std::string(what) + " of an earlier log of this name",
                        "remove the folder or choose another name for the rawlog");
    };
    if (!labels) check(labelsFolderBeside(finalPath), "labels");
    if (!sweeps) check(sweepsFolderBeside(finalPath), "rings and times");
  }

  /// To be called before anything of the scan is written: its folder is none of another log.
  void prepareFor(const PosedScan& scan) {
    if (hasSweep(scan) && !sweeps) sweeps = std::make_unique<SweepFolderWriter>(finalPath);
  }

  std::filesystem::path finalPath;
  AtomicFile file;
  OutputStream out;
  std::unique_ptr<AtomicFolder> labels;
  std::unique_ptr<SweepFolderWriter> sweeps;
  std::uint64_t scans = 0;
};

RawlogWriter::RawlogWriter(const std::filesystem::path& file, bool gz)
    : implementation_(std::make_unique<Implementation>(file, gz)) {}

RawlogWriter::~RawlogWriter() = default;

void RawlogWriter::write(const mrpt::serialization::CSerializable& object) {
  if (implementation_->out.getPosition() == 0) implementation_->checkNoForeignFolders();
  implementation_->out.writeObject(object);
}

void RawlogWriter::write(const PosedScan& scan) {
  implementation_->prepareFor(scan);
  mrpt::obs::CObservationRobotPose pose;
  pose.sensorLabel = kPoseLabel;
  pose.timestamp = toMrptTime(scan.time);
  pose.pose.mean = toMrpt(mapFromRobot(scan));
  write(pose);
  writeWithoutPose(scan);
}

void RawlogWriter::writeWithoutPose(const PosedScan& scan) {
  implementation_->prepareFor(scan);
  const std::string label = scan.sensorLabel.empty() ? kLidarLabel : scan.sensorLabel;
  if (hasSweep(scan)) implementation_->sweeps->write(scan, label);
  mrpt::obs::CObservationPointCloud cloud;
  cloud.sensorLabel = label;
  cloud.timestamp = toMrptTime(scan.time);
  cloud.sensorPose = toMrpt(scan.robotFromSensor);
  cloud.pointcloud = toPointsMap(scan.points);
  write(cloud);
  ++implementation_->scans;
}

void RawlogWriter::write(const PosedScan& scan, const std::vector<std::uint32_t>& labels) {
  if (labels.size() != scan.points.size())
    throw std::logic_error("RawlogWriter: one label per point is needed");
  auto& folder = implementation_->labels;
  if (!folder)
    folder = std::make_unique<AtomicFolder>(labelsFolderBeside(implementation_->finalPath));
  writeLabels(labelPath(folder->temporaryPath(), implementation_->scans), labels);
  write(scan);
}

std::uint64_t RawlogWriter::scanCount() const {
  return implementation_->scans;
}

void RawlogWriter::commit() {
  implementation_->out.close();
  if (implementation_->labels) implementation_->labels->commit();
  if (implementation_->sweeps) implementation_->sweeps->commit();
  implementation_->file.commit();
}

}  // namespace toss
