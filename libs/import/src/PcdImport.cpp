// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/PosedScan.h>
#include <toss/import/PcdImport.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/PcdFile.h>
#include <toss/rawlog/PoseFile.h>
#include <toss/rawlog/RawlogWriter.h>

#include <optional>

#include "PcdFolder.h"
#include "PcdFrameCheck.h"

namespace toss {
namespace {

/// Labels of a scan whose intensities hold them.
std::vector<std::uint32_t> labelsOf(const std::vector<MapPoint>& points,
                                    const std::filesystem::path& file) {
  std::vector<std::uint32_t> labels;
  labels.reserve(points.size());
  for (const MapPoint& point : points) {
    if (point.intensity != 0.0f && point.intensity != 1.0f)
      throw UserError(file.string(),
                      "its intensities are no labels, one is " + std::to_string(point.intensity) +
                          " instead of 0 or 1",
                      "leave --labels out");
    labels.push_back(point.intensity == 1.0f ? label::kFirstMoving : label::kStatic);
  }
  return labels;
}

class Import {
 public:
  Import(const std::filesystem::path& rawlog, const PcdImportOptions& options)
      : options_(options), writer_(rawlog, options.gz) {
    if (!options.poses.empty()) poses_.emplace(options.poses);
    scan_.sensorLabel = options.sensorLabel;
  }

  void add(const PcdFolderEntry& entry, std::uint64_t number) {
    const PcdScan pcd = readPcdScan(entry.file);
    scan_.time = options_.period * entry.place;
    const auto pose = poseOf(pcd, entry.file, number);
    if (!pose) {
      ++result_.withoutPose;
      return;
    }
    scan_.mapFromSensor = *pose;
    fillPoints(pcd);
    check_.add(pcd, *pose);
    result_.points += scan_.points.size();
    if (!options_.labelsFromIntensity) {
      writer_.write(scan_);
      return;
    }
    const std::vector<std::uint32_t> labels = labelsOf(pcd.points, entry.file);
    for (const std::uint32_t value : labels) result_.moving += label::isMoving(value);
    writer_.write(scan_, labels);
  }

  PcdImportResult finish(const std::filesystem::path& folder) {
    result_.scans = writer_.scanCount();
    if (result_.scans == 0)
      throw UserError(options_.poses.string(), "has no pose for any file of " + folder.string(),
                      "check that both are of the same drive");
    if (result_.withoutPose > 0)
      result_.warnings.push_back(std::to_string(result_.withoutPose) + " files were left out, " +
                                 options_.poses.string() + " has no pose for them");
    check_.appendWarnings(options_, result_.warnings);
    writer_.commit();
    return result_;
  }

 private:
  std::optional<Eigen::Isometry3d> poseOf(const PcdScan& pcd, const std::filesystem::path& file,
                                          std::uint64_t number) const {
    if (poses_) return poses_->at(number, scan_.time);
    if (!pcd.viewpoint)
      throw UserError(file.string(), "has no line VIEWPOINT, the pose of the sensor",
                      "write one, or give the poses with --poses");
    return pcd.viewpoint;
  }

  void fillPoints(const PcdScan& pcd) {
    const bool inMap = options_.frame == PcdImportOptions::Frame::Map;
    const Eigen::Isometry3d sensorFromFile =
        inMap ? scan_.mapFromSensor.inverse() : Eigen::Isometry3d::Identity();
    PointCloud& points = scan_.points;
    points.resize(pcd.points.size());
    for (std::size_t i = 0; i < pcd.points.size(); ++i) {
      const MapPoint& from = pcd.points[i];
      const Eigen::Vector3d inFile = pcd.offset + Eigen::Vector3d(from.x, from.y, from.z);
      const Eigen::Vector3f inSensor = (sensorFromFile * inFile).cast<float>();
      points.x[i] = inSensor.x();
      points.y[i] = inSensor.y();
      points.z[i] = inSensor.z();
      points.intensity[i] = options_.labelsFromIntensity ? 0.0f : from.intensity;
    }
  }

  const PcdImportOptions& options_;
  RawlogWriter writer_;
  std::optional<PoseFile> poses_;
  PosedScan scan_;
  PcdFrameCheck check_;
  PcdImportResult result_;
};

}  // namespace

PcdImportResult importPcd(const std::filesystem::path& folder, const std::filesystem::path& rawlog,
                          const PcdImportOptions& options) {
  if (!(options.period > 0.0))
    throw UserError("--period", "is not greater than 0", "give the seconds between two scans");
  const std::vector<PcdFolderEntry> files = pcdFilesIn(folder);
  Import import(rawlog, options);
  for (std::size_t i = 0; i < files.size(); ++i) {
    import.add(files[i], i);
    if (options.progress)
      options.progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  return import.finish(folder);
}

}  // namespace toss
