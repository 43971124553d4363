// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/InputOptions.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace toss {

/// One scan of a folder in KITTI layout.
struct KittiScan {
  /// Number in the file name: row of poses.txt and times.txt, and name of the label file.
  std::uint64_t number = 0;
  std::filesystem::path file;
};

/// What a folder in KITTI layout holds: everything but the points.
struct KittiFolder {
  std::filesystem::path path;
  /// By ascending number.
  std::vector<KittiScan> scans;
  /// map <- LiDAR of row i. Scans whose number is not below its size have no pose.
  std::vector<Eigen::Isometry3d> poses;
  /// Time of row i [s], as MRPT's time stamps keep it.
  std::vector<double> times;
  /// What is odd about the folder and what was made of it.
  std::vector<std::string> warnings;

  bool hasPose(const KittiScan& scan) const { return scan.number < poses.size(); }
};

/// Reads velodyne/ (names only), poses.txt, calib.txt and times.txt of `folder`.
/// Where poses.txt is missing, ../../poses/<name of the folder>.txt is taken: KITTI odometry's own
/// place. Where calib.txt is missing, poses.txt is taken for the LiDAR's own poses; where times.txt
/// is missing, scans come every options.scanPeriod: both with a warning. Throws UserError where the
/// folder has another layout, a file in it is damaged, or rows and scans can't belong together.
KittiFolder readKittiFolder(const std::filesystem::path& folder, const InputOptions& options);

}  // namespace toss
