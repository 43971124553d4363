// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/rawlog/InputOptions.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// Observations of one class and label: a sensor, or a source of poses.
struct StreamSummary {
  std::string label;
  /// Class as MRPT names it, e.g. "mrpt::obs::CObservationPointCloud"; "KITTI .bin" for folders.
  std::string className;
  std::uint64_t count = 0;
  /// Time of the first and last [s, UNIX time or that of times.txt].
  double firstTime = 0.0, lastTime = 0.0;
  /// Per second; 0 where there are fewer than two.
  double rate() const {
    return count < 2 || lastTime <= firstTime
               ? 0.0
               : static_cast<double>(count - 1) / (lastTime - firstTime);
  }

  /// For point clouds: whether they are, fewest and most points of a scan, all points, and the
  /// recognised sensor model ("" = unknown).
  bool pointClouds = false;
  std::uint64_t fewestPoints = 0, mostPoints = 0, points = 0;
  std::string sensorModel;
};

/// What is in an input, as far as it can be told without mapping it.
struct InputSummary {
  std::filesystem::path path;
  /// "rawlog", "rawlog (gz)" or "KITTI folder".
  std::string format;
  /// Size of the rawlog, or of all scans of the folder [bytes].
  std::uint64_t bytes = 0;
  /// Everything that has a time, by class and label.
  std::vector<StreamSummary> streams;
  /// Poses that can be used, and length of the path along them [m].
  std::uint64_t poses = 0;
  double pathLength = 0.0;
  /// Smallest and largest position of the robot [m], map frame; zero without poses.
  Eigen::Vector3d lowest = Eigen::Vector3d::Zero(), highest = Eigen::Vector3d::Zero();
  /// Last position that was entered while gathering.
  std::optional<Eigen::Vector3d> lastPosition;
  /// Scans of all sensors, and of them those whose pose is missing (input.max_pose_gap).
  std::uint64_t scans = 0, scansWithoutPose = 0;
  /// Label files that lie beside the input.
  std::uint64_t labelFiles = 0;
  /// Where the file is damaged, and what else is odd.
  std::vector<std::string> warnings;
};

/// Looks through the whole input. A damaged end becomes a warning where something could be read
/// before it. Throws UserError where nothing can be read at all.
InputSummary summarizeInput(const std::filesystem::path& input, const InputOptions& options = {});

/// Several lines for people, and the same as JSON for programs.
std::string toText(const InputSummary& summary);
std::string toJson(const InputSummary& summary);

}  // namespace toss
