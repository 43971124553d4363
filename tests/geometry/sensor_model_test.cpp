// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/geometry/SensorModel.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace toss {
namespace {

double degrees(double radians) {
  return radians * 180.0 / 3.14159265358979323846;
}

TEST(SensorModel, EveryKnownSensorIsOrderedFromTheTopAndSane) {
  ASSERT_EQ(knownSensors().size(), 10u);
  for (const SensorModel& sensor : knownSensors()) {
    SCOPED_TRACE(sensor.name);
    EXPECT_TRUE(std::is_sorted(sensor.elevations.rbegin(), sensor.elevations.rend()));
    EXPECT_LT(sensor.minRange, sensor.maxRange);
    EXPECT_GE(sensor.columns, 512);
    EXPECT_EQ(&sensorByName(sensor.name), &sensor);
  }
}

TEST(SensorModel, RowsAndFieldOfViewMatchTheDataSheets) {
  EXPECT_EQ(sensorByName("VLP-16").rows(), 16);
  EXPECT_NEAR(degrees(sensorByName("VLP-16").elevations[1]), 13.0, 1e-4);
  EXPECT_EQ(sensorByName("HDL-32E").rows(), 32);
  EXPECT_NEAR(degrees(sensorByName("HDL-32E").elevations[8]), 0.0, 0.01);
  EXPECT_EQ(sensorByName("OS0-128").rows(), 128);
  EXPECT_EQ(sensorByName("OS1-64").rows(), 64);
  // Product line, channels, half the field of view [degrees], range [m].
  const std::vector<std::tuple<std::string, int, double, float>> ouster = {
      {"OS0-64", 64, 45.0, 75.0f},
      {"OS0-32", 32, 45.0, 75.0f},
      {"OS1-128", 128, 22.5, 120.0f},
      {"OS1-32", 32, 22.5, 120.0f},
      {"OS2-128", 128, 11.25, 240.0f}};
  for (const auto& [name, rows, half, range] : ouster) {
    const SensorModel& sensor = sensorByName(name);
    EXPECT_EQ(sensor.rows(), rows) << name;
    EXPECT_NEAR(degrees(sensor.elevations.front()), half, 1e-4) << name;
    EXPECT_NEAR(degrees(sensor.elevations.back()), -half, 1e-4) << name;
    EXPECT_EQ(sensor.maxRange, range) << name;
  }
}

TEST(SensorModel, Hdl64HasAFineAndACoarseBlock) {
  const SensorModel& sensor = sensorByName("HDL-64E");
  ASSERT_EQ(sensor.rows(), 64);
  for (std::size_t row = 0; row + 1 < 64; ++row) {
    const double step = degrees(sensor.elevations[row] - sensor.elevations[row + 1]);
    if (row == 31) continue;
    EXPECT_NEAR(step, row < 31 ? 1.0 / 3.0 : 0.5, 0.01) << row;
  }
}

TEST(SensorModel, AnUnknownNameIsAnsweredWithTheNearestKnownOne) {
  try {
    sensorByName("HDL64E");
    FAIL() << "no error";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("HDL-64E"));
  }
}

/// Median elevation [degrees] of each ring of a scan in KITTI order.
std::vector<double> ringMedians(std::istream& scan) {
  std::vector<std::vector<double>> rings(1);
  double previous = 0.0;
  for (float p[4]; scan.read(reinterpret_cast<char*>(p), sizeof p);) {
    if (p[0] == 0.0f && p[1] == 0.0f) continue;
    double azimuth = degrees(std::atan2(p[1], p[0]));
    if (azimuth < 0.0) azimuth += 360.0;
    if (previous - azimuth > 180.0) rings.emplace_back();
    previous = azimuth;
    rings.back().push_back(degrees(std::atan2(p[2], std::hypot(p[0], p[1]))));
  }
  std::vector<double> medians;
  for (auto& ring : rings) {
    std::nth_element(ring.begin(), ring.begin() + static_cast<long>(ring.size() / 2), ring.end());
    medians.push_back(ring[ring.size() / 2]);
  }
  return medians;
}

TEST(SensorModel, Hdl64AgreesWithARealScan) {
  const char* folder = std::getenv("TOSS_TEST_DATA");
  const std::filesystem::path data = folder ? folder : "../shared/data";
  std::ifstream scan(data / "kitti-tracking-0000/velodyne/000040.bin", std::ios::binary);
  if (!scan) GTEST_SKIP() << "no real data in " << data << ": set TOSS_TEST_DATA";

  const std::vector<double> medians = ringMedians(scan);
  const SensorModel& sensor = sensorByName("HDL-64E");
  ASSERT_EQ(medians.size(), sensor.elevations.size());
  for (std::size_t row = 0; row < medians.size(); ++row) {
    EXPECT_NEAR(degrees(sensor.elevations[row]), medians[row], 0.2) << "row " << row;
  }
}

}  // namespace
}  // namespace toss
