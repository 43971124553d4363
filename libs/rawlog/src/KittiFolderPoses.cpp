// SPDX-License-Identifier: BSD-3-Clause
// Which scan of a KITTI folder has which pose.
#include <toss/geometry/Error.h>
#include <toss/rawlog/PoseFile.h>

#include "KittiFolder.h"
#include "KittiPoses.h"

namespace toss {
namespace {

namespace fs = std::filesystem;

fs::path posesFile(const fs::path& folder) {
  const fs::path own = folder / "poses.txt";
  if (fs::exists(own)) return own;
  const fs::path absolute = fs::absolute(folder / ".").lexically_normal().parent_path();
  const fs::path shared =
      absolute.parent_path().parent_path() / "poses" / (absolute.filename().string() + ".txt");
  if (fs::exists(shared)) return shared;
  throw UserError(own.string(), "does not exist",
                  "put the poses of the scans there, one row of 12 numbers per scan, give a file "
                  "with --poses, or find them with --odometry");
}

/// Rows of `file` and scans must be able to belong together.
void checkRows(const fs::path& file, std::size_t rows, KittiFolder& folder) {
  const std::uint64_t last = folder.scans.back().number;
  if (last < rows) return;
  if (rows == folder.scans.size() || rows <= folder.scans.front().number)
    throw UserError(file.string(),
                    "holds " + std::to_string(rows) + " rows, but the last scan is number " +
                        std::to_string(last) + " and row i belongs to scan number i",
                    "number the scans from 000000.bin on, without gaps");
  folder.warnings.push_back(file.string() + ": holds " + std::to_string(rows) +
                            " rows, scans from number " + std::to_string(rows) +
                            " on have no pose and are skipped");
}

void readOwnPoses(KittiFolder& folder) {
  const fs::path file = posesFile(folder.path);
  const std::vector<Eigen::Isometry3d> poses = readKittiPoses(file);
  const fs::path calibration = folder.path / "calib.txt";
  Eigen::Isometry3d cameraFromLidar = Eigen::Isometry3d::Identity();
  if (fs::exists(calibration))
    cameraFromLidar = readKittiCalibration(calibration);
  else
    folder.warnings.push_back(calibration.string() +
                              ": does not exist, poses.txt is taken for the poses of the LiDAR "
                              "itself (KITTI's are the camera's: they need calib.txt)");
  checkRows(file, poses.size(), folder);
  for (KittiScan& scan : folder.scans)
    if (scan.number < poses.size()) scan.pose = lidarPose(poses[scan.number], cameraFromLidar);
}

/// camera <- LiDAR, or the identity where the poses of `file` are the LiDAR's.
Eigen::Isometry3d subjectFromLidar(const PoseFile& file, const InputOptions& options,
                                   KittiFolder& folder) {
  const fs::path calibration = folder.path / "calib.txt";
  const bool camera = options.poseOf == PoseSubject::Camera ||
                      (options.poseOf == PoseSubject::Automatic &&
                       file.format() == PoseFileFormat::Kitti && fs::exists(calibration));
  if (options.poseOf == PoseSubject::Automatic)
    folder.warnings.push_back(options.poseFile + ": its poses are taken for those of the " +
                              (camera ? "camera, as in KITTI's own files" : "LiDAR") +
                              "; say what they are of with input.pose_of");
  return camera ? readKittiCalibration(calibration) : Eigen::Isometry3d::Identity();
}

void readPoseFile(const InputOptions& options, KittiFolder& folder) {
  const PoseFile file(options.poseFile, options.maxPoseGap);
  const Eigen::Isometry3d toLidar = subjectFromLidar(file, options, folder);
  if (file.format() == PoseFileFormat::Kitti)
    checkRows(options.poseFile, file.poses().size(), folder);
  std::uint64_t found = 0;
  for (KittiScan& scan : folder.scans) {
    if (!scan.time) continue;
    scan.pose = file.at(scan.number, *scan.time + options.timeOffset);
    if (scan.pose) scan.pose = lidarPose(*scan.pose, toLidar);
    found += scan.pose.has_value();
  }
  if (found == 0)
    throw UserError(options.poseFile, "has no pose near enough in time to any scan",
                    "check the times, set input.time_offset or raise input.max_pose_gap");
  if (found < folder.scans.size())
    folder.warnings.push_back(options.poseFile + ": has no pose for " +
                              std::to_string(folder.scans.size() - found) +
                              " scans, they are skipped (input.max_pose_gap)");
}

}  // namespace

void readKittiFolderPoses(const InputOptions& options, KittiFolder& folder) {
  if (options.withoutPoses)
    for (KittiScan& scan : folder.scans) scan.pose = Eigen::Isometry3d::Identity();
  else if (!options.poseFile.empty())
    readPoseFile(options, folder);
  else
    readOwnPoses(folder);
}

}  // namespace toss
