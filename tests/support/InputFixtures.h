// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/ScanSource.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

/// Inputs for tests of reading and writing, made in a temporary folder.
namespace toss::test {

namespace fs = std::filesystem;

/// A new folder that is removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::path(::testing::TempDir()) / "toss_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

/// The real data: TOSS_TEST_DATA or shared/data beside the checkout; empty where it is absent.
inline fs::path dataFolder() {
  const char* given = std::getenv("TOSS_TEST_DATA");
  const fs::path checkout = fs::path(__FILE__).parent_path().parent_path().parent_path();
  const fs::path folder = given ? fs::path(given) : checkout.parent_path() / "shared/data";
  return fs::is_directory(folder) ? folder : fs::path();
}

inline std::string readBytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void writeBytes(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

/// What the UserError that `action` throws says; "" if it throws none.
template <typename Action>
std::string userErrorOf(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

inline Eigen::Isometry3d poseOf(double x, double y, double z, double yaw, double pitch = 0,
                                double roll = 0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << x, y, z;
  pose.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

/// Scan number `index` at 10 Hz; random points with a NaN, an infinity and a return at the origin.
inline PosedScan makeScan(std::uint64_t index, std::size_t points = 50) {
  std::mt19937 random(static_cast<unsigned>(index) + 1);
  std::uniform_real_distribution<float> coordinate(-40.0f, 40.0f), share(0.0f, 1.0f);
  const double i = static_cast<double>(index);
  PosedScan scan;
  scan.index = index;
  scan.time = 1.6e9 + 0.1 * i;
  scan.mapFromSensor = poseOf(1.3 * i + 0.1, -0.7 * i, 0.01 * i, 0.3 * i, 0.02, -0.01 * i);
  scan.points.resize(points);
  for (std::size_t p = 0; p < points; ++p) {
    scan.points.x[p] = coordinate(random);
    scan.points.y[p] = coordinate(random);
    scan.points.z[p] = 0.1f * coordinate(random);
    scan.points.intensity[p] = share(random);
  }
  if (points > 5) {
    scan.points.x[2] = std::numeric_limits<float>::quiet_NaN();
    scan.points.y[3] = std::numeric_limits<float>::infinity();
    scan.points.x[4] = scan.points.y[4] = scan.points.z[4] = 0.0f;
  }
  return scan;
}

using Object = mrpt::serialization::CSerializable::Ptr;

inline mrpt::obs::CObservationRobotPose::Ptr poseObservation(double time,
                                                             const Eigen::Isometry3d& pose) {
  auto observation = mrpt::obs::CObservationRobotPose::Create();
  observation->timestamp = toMrptTime(time);
  observation->sensorLabel = "slam";
  observation->pose.mean = toMrpt(pose);
  return observation;
}

inline mrpt::obs::CObservationPointCloud::Ptr cloudObservation(double time, const PosedScan& scan,
                                                               const std::string& label = "lidar") {
  auto observation = mrpt::obs::CObservationPointCloud::Create();
  observation->timestamp = toMrptTime(time);
  observation->sensorLabel = label;
  auto map = mrpt::maps::CPointsMapXYZI::Create();
  map->resize(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    map->setPointAllFieldsFast(
        i, {scan.points.x[i], scan.points.y[i], scan.points.z[i], scan.points.intensity[i]});
  observation->pointcloud = map;
  return observation;
}

/// Writes objects one after another with MRPT's own streams.
inline void writeObjects(const fs::path& file, const std::vector<Object>& objects,
                         bool gz = false) {
  const auto writeTo = [&](auto& stream) {
    auto archive = mrpt::serialization::archiveFrom(stream);
    for (const auto& object : objects) archive << *object;
  };
  if (gz) {
    mrpt::io::CFileGZOutputStream stream(file.string(), mrpt::io::OpenMode::TRUNCATE, 1);
    writeTo(stream);
  } else {
    mrpt::io::CFileOutputStream stream(file.string());
    writeTo(stream);
  }
}

/// Pose and cloud of `count` scans, in the order in which a SLAM system writes them.
inline std::vector<Object> logOf(std::size_t count) {
  std::vector<Object> objects;
  for (std::size_t i = 0; i < count; ++i) {
    const PosedScan scan = makeScan(i);
    objects.push_back(poseObservation(scan.time, scan.mapFromSensor));
    objects.push_back(cloudObservation(scan.time, scan));
  }
  return objects;
}

/// All scans of an input and the report at the end.
struct ReadInput {
  std::vector<PosedScan> scans;
  InputReport report;
};

inline ReadInput readInput(const fs::path& input, const InputOptions& options = {}) {
  ReadInput result;
  const auto source = openScans(input, options);
  PosedScan scan;
  while (source->next(scan)) result.scans.push_back(scan);
  result.report = source->report();
  return result;
}

inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

/// Points, time and pose bit for bit.
inline void expectSameScan(const PosedScan& a, const PosedScan& b) {
  EXPECT_TRUE(sameBits(a.points.x, b.points.x));
  EXPECT_TRUE(sameBits(a.points.y, b.points.y));
  EXPECT_TRUE(sameBits(a.points.z, b.points.z));
  EXPECT_TRUE(sameBits(a.points.intensity, b.points.intensity));
  EXPECT_EQ(a.time, b.time);
  EXPECT_TRUE(a.mapFromSensor.matrix() == b.mapFromSensor.matrix());
}

}  // namespace toss::test
