// SPDX-License-Identifier: BSD-3-Clause
#include "KittiPoses.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/PoseFile.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "NumberLines.h"

namespace toss {
namespace {

Eigen::Isometry3d inverseOf(const Eigen::Isometry3d& pose) {
  // A rotation read from text is not orthogonal to the last digit: its transpose is no inverse.
  return Eigen::Isometry3d(pose.matrix().inverse());
}

bool isIdentity(const Eigen::Isometry3d& pose) {
  return pose.matrix() == Eigen::Matrix4d::Identity();
}

}  // namespace

std::optional<Eigen::Isometry3d> parseKittiPose(const std::string& text) {
  const std::vector<double> numbers = parseNumbers(text);
  if (numbers.size() != 12) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) pose(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
  return isRigid(pose) ? std::optional(pose) : std::nullopt;
}

Eigen::Isometry3d lidarPose(const Eigen::Isometry3d& cameraPose,
                            const Eigen::Isometry3d& cameraFromLidar) {
  if (isIdentity(cameraFromLidar)) return cameraPose;
  return inverseOf(cameraFromLidar) * cameraPose * cameraFromLidar;
}

Eigen::Isometry3d cameraPose(const Eigen::Isometry3d& lidarPose,
                             const Eigen::Isometry3d& cameraFromLidar) {
  if (isIdentity(cameraFromLidar)) return lidarPose;
  return cameraFromLidar * lidarPose * inverseOf(cameraFromLidar);
}

std::string kittiNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string kittiRow(const Eigen::Isometry3d& pose) {
  std::string row;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) row += (row.empty() ? "" : " ") + kittiNumber(pose(r, c));
  return row + "\n";
}

std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file) {
  std::vector<Eigen::Isometry3d> poses;
  forEachLine(file, [&](const std::string& line, int number) {
    const auto pose = parseKittiPose(line);
    if (!pose)
      throw UserError(lineOf(file, number), "is no pose: 12 numbers, a rotation and a translation",
                      "write one row r11 r12 r13 tx r21 ... tz per scan");
    poses.push_back(*pose);
  });
  return poses;
}

Eigen::Isometry3d readKittiCalibration(const std::filesystem::path& file) {
  std::optional<Eigen::Isometry3d> found;
  forEachLine(file, [&](const std::string& line, int number) {
    const std::size_t nameEnd = line.find_first_of(": ");
    const std::string name = line.substr(0, nameEnd);
    if (name != "Tr" && name != "Tr_velo_cam" && name != "Tr_velo_to_cam") return;
    const std::size_t begin = line.find_first_not_of(": ", nameEnd);
    found = parseKittiPose(begin == std::string::npos ? "" : line.substr(begin));
    if (!found)
      throw UserError(lineOf(file, number), "is no pose: 12 numbers, a rotation and a translation",
                      "give the calibration camera <- LiDAR as \"Tr: r11 r12 r13 tx r21 ... tz\"");
  });
  if (!found)
    throw UserError(file.string(), "holds no \"Tr:\" (camera <- LiDAR)",
                    "add it, or remove the file if poses.txt holds the LiDAR's own poses");
  return *found;
}

Eigen::Isometry3d cameraFromLidarOf(const std::filesystem::path& input) {
  const std::filesystem::path calibration = input / "calib.txt";
  std::error_code ignored;
  if (!std::filesystem::exists(calibration, ignored)) return Eigen::Isometry3d::Identity();
  return readKittiCalibration(calibration);
}

std::vector<double> readKittiTimes(const std::filesystem::path& file) {
  std::vector<double> times;
  forEachLine(file, [&](const std::string& line, int number) {
    const std::vector<double> numbers = parseNumbers(line);
    if (numbers.size() != 1 || !std::isfinite(numbers[0]))
      throw UserError(lineOf(file, number), "is no time in seconds", "write one number per scan");
    if (!times.empty() && numbers[0] <= times.back())
      throw UserError(lineOf(file, number), "is not later than the line before it",
                      "put the scans in the order of time");
    times.push_back(numbers[0]);
  });
  return times;
}

}  // namespace toss
