// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/rawlog/SensorRecognition.h>

#include <cmath>

namespace toss::test {
namespace {

/// A scan of a room with walls at various distances, as the sensor sees it; all returns, or only
/// those of the ground 1.7 m below.
PosedScan scanOf(const SensorModel& sensor, bool groundOnly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> range(6.0f, 40.0f), turn(-3.14f, 3.14f);
  PosedScan scan;
  for (const float elevation : sensor.elevations) {
    if (groundOnly && elevation > -0.01f) continue;
    for (int i = 0; i < 300; ++i) {
      const float r = groundOnly ? -1.7f / std::sin(elevation) : range(random);
      const float azimuth = turn(random);
      scan.points.x.push_back(r * std::cos(elevation) * std::cos(azimuth));
      scan.points.y.push_back(r * std::cos(elevation) * std::sin(azimuth));
      scan.points.z.push_back(r * std::sin(elevation));
    }
  }
  return scan;
}

TEST(SensorRecognition, KnowsEachModelByItsBeams) {
  for (const SensorModel& sensor : knownSensors())
    EXPECT_EQ(recognizeSensor(scanOf(sensor, false)), sensor.name);
}

TEST(SensorRecognition, KnowsLongRangeModelsByTheirGroundReturns) {
  for (const char* name : {"HDL-64E", "HDL-32E", "VLP-16", "OS1-64"})
    EXPECT_EQ(recognizeSensor(scanOf(sensorByName(name), true)), name);
}

TEST(SensorRecognition, TakesWhatTheInputTells) {
  PosedScan scan = scanOf(sensorByName("VLP-16"), false);
  scan.sensorLabel = "velodyne_hdl32_front";
  EXPECT_EQ(recognizeSensor(scan), "HDL-32E");
  scan.sensorLabel = "my os1-64";
  EXPECT_EQ(recognizeSensor(scan), "OS1-64");
  scan.sensorModel = "HDL-64E";
  EXPECT_EQ(recognizeSensor(scan), "HDL-64E");
}

TEST(SensorRecognition, AdmitsWhatItDoesNotKnow) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate(-20.0f, 20.0f);
  PosedScan scan;
  EXPECT_EQ(recognizeSensor(scan), "");
  for (int i = 0; i < 20000; ++i) {
    scan.points.x.push_back(coordinate(random));
    scan.points.y.push_back(coordinate(random));
    scan.points.z.push_back(0.2f * coordinate(random));
  }
  EXPECT_EQ(recognizeSensor(scan), "");
}

TEST(SensorRecognition, MeasuresAgreement) {
  const SensorModel& sensor = sensorByName("VLP-16");
  const BeamAgreement own = beamAgreement(scanOf(sensor, false).points, sensor);
  EXPECT_NEAR(own.score(), 1.0, 1e-3);
  const BeamAgreement upper = beamAgreement(scanOf(sensor, true).points, sensor);
  EXPECT_NEAR(upper.beamsUsed, 0.5, 1e-9);
}

TEST(SensorRecognition, KnowsAScanThatWasCorrectedForMotion) {
  const fs::path folder = dataFolder() / "semantickitti-one-scan";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  TemporaryFolder copy;
  writeBytes(copy / "a/velodyne/000000.bin", readBytes(folder / "000000.bin"));
  writeBytes(copy / "a/poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(readInput(copy / "a").scans.at(0).sensorModel, "HDL-64E");
}

}  // namespace
}  // namespace toss::test
