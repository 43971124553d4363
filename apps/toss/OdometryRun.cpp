// SPDX-License-Identifier: BSD-3-Clause
#include "OdometryRun.h"

#include <toss/odometry/LidarOdometry.h>
#include <toss/rawlog/LidarSelection.h>

#include <cstdio>

#include "Progress.h"
#include "ScanRange.h"

namespace toss {
namespace {

/// Overlap with the local map, and weakest hold, below which a pose is doubtful.
constexpr double kLeastOverlap = 0.5, kLeastHold = 0.03;

void judge(const Alignment& alignment, Trajectory& trajectory) {
  if (trajectory.poses.size() < 2) return;
  trajectory.lost += alignment.overlap < kLeastOverlap;
  trajectory.loose += alignment.weakestHold < kLeastHold;
  const std::size_t last = trajectory.poses.size() - 1;
  trajectory.length +=
      (trajectory.poses[last].translation() - trajectory.poses[last - 1].translation()).norm();
}

}  // namespace

Trajectory findPoses(const ScanChoice& choice, const RunConfiguration& configuration, bool quiet) {
  InputOptions input = withSelectedLidars(choice.input, configuration.input);
  input.withoutPoses = true;
  ScanRange scans(choice.input, input, choice.from, choice.to);
  LidarOdometry odometry(configuration.odometry);
  Progress progress("odometry", "scans", quiet);
  Trajectory trajectory;
  PosedScan scan;
  while (scans.next(scan)) {
    // Of several LiDARs the first one tells the way of all.
    if (input.sensorLabels.size() > 1 && scan.sensorLabel != input.sensorLabels.front()) continue;
    trajectory.poses.push_back(odometry.add(scan));
    trajectory.times.push_back(scan.time);
    trajectory.scans.push_back(scan.index);
    judge(odometry.alignment(), trajectory);
    progress.update(trajectory.poses.size(), scans.progress());
  }
  if (trajectory.poses.empty())
    throw UserError(choice.input.string(), "holds no scan in the chosen range",
                    "look at it with toss info");
  trajectory.warnings = scans.report().warnings;
  return trajectory;
}

void writeTrajectory(const Trajectory& trajectory, PoseFileFormat format,
                     const std::filesystem::path& file, const std::filesystem::path& input) {
  std::vector<Eigen::Isometry3d> poses = trajectory.poses;
  if (format == PoseFileFormat::Kitti) {
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (trajectory.scans[i] != i)
        throw UserError(file.string(),
                        "scan " + std::to_string(i) +
                            " has no pose, and row i of the KITTI format "
                            "belongs to scan i",
                        "write the TUM format, which holds times");
    const Eigen::Isometry3d cameraFromLidar = cameraFromLidarOf(input);
    for (Eigen::Isometry3d& pose : poses) pose = cameraPose(pose, cameraFromLidar);
  }
  writePoseFile(file, format, trajectory.times, poses);
}

std::string noteOn(const Trajectory& trajectory) {
  char text[160];
  std::snprintf(text, sizeof text, "odometry: %zu poses along %.1f m\n", trajectory.poses.size(),
                trajectory.length);
  std::string note = text;
  if (trajectory.lost > 0)
    note += "note: " + std::to_string(trajectory.lost) +
            " scans overlap little with what was seen before them: their poses are doubtful\n";
  if (trajectory.loose > 0)
    note += "note: " + std::to_string(trajectory.loose) +
            " scans show surfaces along which the LiDAR could slide unnoticed (a tunnel, an open "
            "field): their poses are doubtful\n";
  return note;
}

}  // namespace toss
