// SPDX-License-Identifier: BSD-3-Clause
#include "KittiPoses.h"

#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

namespace toss {
namespace {

/// All numbers of a text; none at all if anything in it is no number.
std::vector<double> parseNumbers(const std::string& text) {
  std::vector<double> numbers;
  const char* next = text.c_str();
  for (;;) {
    char* end = nullptr;
    const double value = std::strtod(next, &end);
    if (end == next) break;
    numbers.push_back(value);
    next = end;
  }
  const bool clean = std::string(next).find_first_not_of(" \t\r,") == std::string::npos;
  return clean ? numbers : std::vector<double>();
}

std::optional<Eigen::Isometry3d> parsePose(const std::string& text) {
  const std::vector<double> numbers = parseNumbers(text);
  if (numbers.size() != 12) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) pose(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
  return isRigid(pose) ? std::optional(pose) : std::nullopt;
}

/// Calls `use` with each line that is not blank; lines are counted from 1.
template <typename Use>
void forEachLine(const std::filesystem::path& file, Use use) {
  std::ifstream in(file);
  if (!in) throw UserError(file.string(), "can't be read", "check that the file exists");
  std::string line;
  for (int number = 1; std::getline(in, line); ++number)
    if (line.find_first_not_of(" \t\r") != std::string::npos) use(line, number);
}

std::string at(const std::filesystem::path& file, int line) {
  return file.string() + ": line " + std::to_string(line);
}

Eigen::Isometry3d inverseOf(const Eigen::Isometry3d& pose) {
  // A rotation read from text is not orthogonal to the last digit: its transpose is no inverse.
  return Eigen::Isometry3d(pose.matrix().inverse());
}

bool isIdentity(const Eigen::Isometry3d& pose) {
  return pose.matrix() == Eigen::Matrix4d::Identity();
}

}  // namespace

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

std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file) {
  std::vector<Eigen::Isometry3d> poses;
  forEachLine(file, [&](const std::string& line, int number) {
    const auto pose = parsePose(line);
    if (!pose)
      throw UserError(at(file, number), "is no pose: 12 numbers, a rotation and a translation",
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
    found = parsePose(begin == std::string::npos ? "" : line.substr(begin));
    if (!found)
      throw UserError(at(file, number), "is no pose: 12 numbers, a rotation and a translation",
                      "give the calibration camera <- LiDAR as \"Tr: r11 r12 r13 tx r21 ... tz\"");
  });
  if (!found)
    throw UserError(file.string(), "holds no \"Tr:\" (camera <- LiDAR)",
                    "add it, or remove the file if poses.txt holds the LiDAR's own poses");
  return *found;
}

std::vector<double> readKittiTimes(const std::filesystem::path& file) {
  std::vector<double> times;
  forEachLine(file, [&](const std::string& line, int number) {
    const std::vector<double> numbers = parseNumbers(line);
    if (numbers.size() != 1 || !std::isfinite(numbers[0]))
      throw UserError(at(file, number), "is no time in seconds", "write one number per scan");
    if (!times.empty() && numbers[0] <= times.back())
      throw UserError(at(file, number), "is not later than the line before it",
                      "put the scans in the order of time");
    times.push_back(numbers[0]);
  });
  return times;
}

}  // namespace toss
