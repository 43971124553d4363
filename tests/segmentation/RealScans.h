// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// Leaves the test, saying so, where the folder of real scans is absent.
#define TOSS_NEED_REAL_DATA(folder)                                          \
  if (!std::filesystem::exists(folder)) {                                    \
    GTEST_SKIP() << "no real data: set TOSS_TEST_DATA to the folder of it "; \
  }

namespace toss::test {

inline std::filesystem::path realDataFolder() {
  const char* const given = std::getenv("TOSS_TEST_DATA");
  if (given != nullptr) return given;
  // Beside the checkout, which holds tests/segmentation/<this file>.
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path() / ".." /
         "shared" / "data";
}

/// The elements of a binary file.
template <typename T>
std::vector<T> readBinary(const std::filesystem::path& file) {
  std::vector<T> values(std::filesystem::file_size(file) / sizeof(T));
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(T)));
  return values;
}

/// x y z intensity, four floats a return.
inline PointCloud readVelodyneBin(const std::filesystem::path& file) {
  const std::vector<float> values = readBinary<float>(file);
  PointCloud points;
  points.resize(values.size() / 4);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.x[i] = values[4 * i], points.y[i] = values[4 * i + 1];
    points.z[i] = values[4 * i + 2], points.intensity[i] = values[4 * i + 3];
  }
  return points;
}

inline Eigen::Isometry3d parsePose(const std::string& twelveNumbers) {
  std::istringstream text(twelveNumbers);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 12; ++i) text >> pose.matrix()(i / 4, i % 4);
  return pose;
}

/// Real sequence with labels: scans by number.
class KittiSequence {
 public:
  static std::filesystem::path folder() { return realDataFolder() / "kitti-tracking-0000"; }

  KittiSequence() {
    Eigen::Isometry3d cameraFromLidar = Eigen::Isometry3d::Identity();
    std::ifstream calibration(folder() / "calib.txt"), poses(folder() / "poses.txt");
    std::string line;
    while (std::getline(calibration, line)) {
      if (line.rfind("Tr:", 0) == 0) cameraFromLidar = parsePose(line.substr(3));
    }
    while (std::getline(poses, line)) {
      poses_.push_back(cameraFromLidar.inverse() * parsePose(line) * cameraFromLidar);
    }
  }

  std::size_t size() const { return poses_.size(); }
  const Eigen::Isometry3d& mapFromSensor(std::size_t scan) const { return poses_[scan]; }
  PointCloud points(std::size_t scan) const {
    return readVelodyneBin(folder() / "velodyne" / (name(scan) + ".bin"));
  }
  std::vector<std::uint32_t> labels(std::size_t scan) const {
    return readBinary<std::uint32_t>(folder() / "labels" / (name(scan) + ".label"));
  }

 private:
  static std::string name(std::size_t scan) {
    const std::string number = std::to_string(scan);
    return std::string(6 - number.size(), '0') + number;
  }
  std::vector<Eigen::Isometry3d> poses_;
};

}  // namespace toss::test
