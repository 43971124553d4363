// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/InputOptions.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// One scan of a folder in KITTI layout.
struct KittiScan {
  /// Number in the file name: row of poses.txt and times.txt, and name of the label file.
  std::uint64_t number = 0;
  std::filesystem::path file;
  /// Time [s], as MRPT's time stamps keep it; none where times.txt has no such row.
  std::optional<double> time;
  /// map <- LiDAR, where there is one.
  std::optional<Eigen::Isometry3d> pose;
};

/// What a folder in KITTI layout holds: everything but the points.
struct KittiFolder {
  std::filesystem::path path;
  /// By ascending number.
  std::vector<KittiScan> scans;
  /// What is odd about the folder and what was made of it.
  std::vector<std::string> warnings;
};

/// Reads velodyne/ (names only), poses.txt, calib.txt and times.txt of `folder`.
/// Where poses.txt is missing, ../../poses/<name of the folder>.txt is taken: KITTI odometry's own
/// place; options.poseFile replaces both. Where calib.txt is missing, poses.txt is taken for the
/// LiDAR's own poses; where times.txt is missing, scans come every options.scanPeriod: both with a
/// warning. With options.withoutPoses every pose is the identity, and neither poses.txt nor
/// calib.txt is looked at. Scans with a pose have a time. Throws UserError where the folder has
/// another layout, a file in it is damaged, or rows and scans can't belong together.
KittiFolder readKittiFolder(const std::filesystem::path& folder, const InputOptions& options);

/// The part of it that gives poses to the scans.
void readKittiFolderPoses(const InputOptions& options, KittiFolder& folder);

}  // namespace toss
