// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/PoseFile.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "RunConfiguration.h"

namespace toss {

/// Scans of an input, by their number in it, both included.
struct ScanChoice {
  std::filesystem::path input;
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max();
};

/// Poses of the LiDAR, found from the scans alone.
struct Trajectory {
  /// Number in the input, time [s] and pose (map <- sensor) of each scan; shape [n] each.
  std::vector<std::uint64_t> scans;
  std::vector<double> times;
  std::vector<Eigen::Isometry3d> poses;
  /// Length of the way [m].
  double length = 0.0;
  /// Scans of which less than half lies on what was seen before, and scans that the geometry lets
  /// slide in some direction.
  std::uint64_t lost = 0, loose = 0;
  /// What reading the input has found.
  std::vector<std::string> warnings;
};

/// Runs the odometry over the scans. Throws UserError where there is no scan.
Trajectory findPoses(const ScanChoice& choice, const RunConfiguration& configuration, bool quiet);

/// Writes them: TUM the LiDAR's poses; KITTI, for a folder with calib.txt, the camera's, as KITTI's
/// own files hold them, one row per scan of the input. `input`: only KITTI needs it. Throws
/// UserError where the file can't be written, or scans are missing in KITTI format.
void writeTrajectory(const Trajectory& trajectory, PoseFileFormat format,
                     const std::filesystem::path& file, const std::filesystem::path& input = {});

/// Lines for people: number of scans, length, and where the poses are doubtful.
std::string noteOn(const Trajectory& trajectory);

}  // namespace toss
