// SPDX-License-Identifier: BSD-3-Clause
#include "Sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "objects/Structures.h"
#include "objects/Vehicles.h"
#include "test_worlds.h"

namespace toss::simulation {
namespace {

constexpr SweepSettings kExact{0.1, true, false};
constexpr SweepSettings kExactRaw{0.1, false, false};

TEST(Sweep, RangesToALevelPlaneAreHeightOverSine) {
  World world = levelWorld();
  world.carrier.sensorHeight = 2.0;
  const SensorModel& sensor = sensorByName("VLP-16");
  const SweepReturns returns = revolution(world, sensor, kExact);
  for (std::size_t i = 0; i < returns.beams.size(); ++i) {
    const auto row = i / static_cast<std::size_t>(sensor.columns);
    const double elevation = static_cast<double>(sensor.elevations[row]);
    const double range = elevation < 0.0 ? -2.0 / std::sin(elevation) : 0.0;
    const double expected = range <= static_cast<double>(sensor.maxRange) ? range : 0.0;
    ASSERT_NEAR(returns.beams[i].range, expected, 1e-6) << "beam " << i;
    ASSERT_EQ(returns.beams[i].label, expected > 0.0 ? semantics::kRoad : 0);
  }
}

TEST(Sweep, RangesToAWallAreItsDistanceOverTheCosines) {
  World world = levelWorld();
  world.add(makeWall(80.0, 12.0, 0.2), planarPose(-40.0, 10.1, 0.0, 0.0));
  const SensorModel& sensor = sensorByName("VLP-16");
  const SweepReturns returns = revolution(world, sensor, kExact);
  int onWall = 0;
  for (std::size_t i = 0; i < returns.beams.size(); ++i) {
    if (returns.beams[i].label != semantics::kBuilding) continue;
    if (returns.points[i].z() > 10.0f) continue;
    ++onWall;
    ASSERT_NEAR(returns.points[i].y(), 10.0f, 2e-5f) << "beam " << i;
    const auto row = i / static_cast<std::size_t>(sensor.columns);
    const double azimuth = 2.0 * M_PI * (static_cast<double>(i % 1800) + 0.5) / 1800.0;
    const double elevation = static_cast<double>(sensor.elevations[row]);
    ASSERT_NEAR(returns.beams[i].range, 10.0 / (std::sin(azimuth) * std::cos(elevation)), 1e-5);
  }
  EXPECT_GT(onWall, 5000);
}

TEST(Sweep, RawPointsOfADrivingSensorLieWhereTheSensorWasAtThatTime) {
  constexpr double kSpeed = 20.0;
  World world = levelWorld();
  world.add(makeWall(40.0, 8.0, 0.2), planarPose(15.1, -20.0, 0.0, 0.5 * M_PI));
  drive(world, kSpeed);
  const SensorModel& sensor = sensorByName("VLP-16");
  const SweepReturns raw = revolution(world, sensor, kExactRaw);
  int onWall = 0;
  for (std::size_t i = 0; i < raw.beams.size(); ++i) {
    if (raw.beams[i].label != semantics::kBuilding) continue;
    ++onWall;
    const double time = columnTime(static_cast<int>(i) % sensor.columns, sensor.columns, 0.1);
    ASSERT_NEAR(static_cast<double>(raw.points[i].x()), 15.0 - kSpeed * time, 2e-5);
  }
  EXPECT_GT(onWall, 1000);
}

TEST(Sweep, CompensationPutsStaticPointsOnTheirSurfaceAtTheStamp) {
  World world = levelWorld();
  world.add(makeWall(40.0, 8.0, 0.2), planarPose(15.1, -20.0, 0.0, 0.5 * M_PI));
  drive(world, 20.0);
  const SweepReturns returns = revolution(world, sensorByName("VLP-16"), kExact);
  for (std::size_t i = 0; i < returns.beams.size(); ++i) {
    if (returns.beams[i].label != semantics::kBuilding) continue;
    ASSERT_NEAR(returns.points[i].x(), 15.0f, 2e-5f);
  }
}

TEST(Sweep, ObjectsStaySmearedByTheirOwnMotion) {
  constexpr double kSpeed = 15.0;
  World world = levelWorld();
  drive(world, 5.0);
  world.addMover(makeBoxCar({2.0, 20.0, 1.6}),
                 {Path({{12.0, 0.0}, {100.0, 0.0}}), SpeedProfile::constant(kSpeed), 0.0});
  const SensorModel& sensor = sensorByName("VLP-16");
  const SweepReturns returns = revolution(world, sensor, kExact);
  int onRear = 0;
  for (std::size_t i = 0; i < returns.beams.size(); ++i) {
    if (returns.beams[i].instance != 1 || returns.points[i].z() > -0.2f) continue;
    ++onRear;
    const double time = columnTime(static_cast<int>(i) % sensor.columns, sensor.columns, 0.1);
    ASSERT_NEAR(static_cast<double>(returns.points[i].x()), 11.0 + kSpeed * time, 1e-4);
  }
  EXPECT_GT(onRear, 500);
}

TEST(Sweep, NoiseSpreadsRangesByWhatTheDataSheetSays) {
  World world = levelWorld();
  world.add(makeWall(80.0, 12.0, 0.2), planarPose(-40.0, 10.1, 0.0, 0.0));
  const SensorModel& sensor = sensorByName("HDL-32E");
  const SweepReturns exact = revolution(world, sensor, kExact);
  const SweepReturns noisy = revolution(world, sensor, {0.1, true, true});
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < exact.beams.size(); ++i) {
    if (noisy.beams[i].range <= 0.0 || noisy.beams[i].label != semantics::kBuilding) continue;
    // Farther to the sides beams are wide on the wall.
    if (std::abs(exact.points[i].x()) > 8.0f) continue;
    const double error = noisy.beams[i].range - exact.beams[i].range;
    sum += error, squares += error * error, count += 1.0;
  }
  ASSERT_GT(count, 5000.0);
  EXPECT_NEAR(sum / count, 0.0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / count), 0.02, 0.001);
}

TEST(Sweep, TheSweepRunsClockwiseFromTheRear) {
  EXPECT_NEAR(columnTime(0, 1000, 0.1), 0.0, 1e-4);
  EXPECT_NEAR(columnTime(250, 1000, 0.1), -0.025, 1e-4);
  EXPECT_NEAR(columnTime(499, 1000, 0.1), -0.05, 1e-4);
  EXPECT_NEAR(columnTime(500, 1000, 0.1), 0.05, 1e-4);
  EXPECT_NEAR(columnTime(750, 1000, 0.1), 0.025, 1e-4);
}

}  // namespace
}  // namespace toss::simulation
