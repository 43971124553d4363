// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GroundTestRun.h"

namespace toss::test {
namespace {

using Scene = GroundTestScene;

double radians(double degrees) {
  return degrees * M_PI / 180.0;
}

bool within30Metres(const Eigen::Vector3d&, double range) {
  return range < 30.0;
}

/// A plane of the given slope with people on it, seen by a sensor that stands on it.
struct Hillside {
  Scene scene;
  double slope;

  explicit Hillside(double degrees) : slope(std::tan(radians(degrees))) {
    scene.addGround(0.0, slope);
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.3 + 0.785 * i, distance = 3.0 + 2.0 * i;
      const Eigen::Vector3d foot(distance * std::cos(angle), distance * std::sin(angle), 0.0);
      const double z = slope * foot.x();
      scene.addBox(foot + Eigen::Vector3d(-0.25, -0.25, z - 0.2),
                   foot + Eigen::Vector3d(0.25, 0.25, z + 1.7), Scene::Object);
    }
  }
};

class GroundOnSlope : public testing::TestWithParam<double> {};

TEST_P(GroundOnSlope, IsFoundAndKeepsPeopleOut) {
  const Hillside hill(GetParam());
  const SensorModel& sensor = sensorByName("OS0-128");
  // The sensor stands upright, or tilted with the slope as on a legged robot.
  for (const double pitch : {0.0, -radians(GetParam())}) {
    const auto scan = hill.scene.scan(sensor, sensorAt({0, 0, 0.6}, 0.4, pitch));
    const GroundTestRun run(scan, sensor, GroundOptions{});
    EXPECT_GT(run.shares(Scene::Ground, within30Metres).ground, 0.97);
    EXPECT_LT(run.shares(Scene::Ground).below, 5e-4);
    const GroundShares people = run.shares(Scene::Object, within30Metres);
    ASSERT_GT(people.count, 200);
    EXPECT_LT(people.ground, 0.04);
    EXPECT_LT(people.unknownHeight, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, GroundOnSlope, testing::Values(0.0, 10.0, 20.0, 25.0, 30.0));

TEST(GroundHeight, IsTheDistanceFromTheTruePlane) {
  const Hillside hill(12.0);
  const SensorModel& sensor = sensorByName("HDL-64E");
  const auto scan = hill.scene.scan(sensor, sensorAt({0, 0, 1.73}, 0.0, -radians(12.0), 0.05));
  const GroundTestRun run(scan, sensor, GroundOptions{});
  int far = 0, checked = 0;
  for (std::size_t i = 0; i < run.scan.surface.size(); ++i) {
    if (run.image.row[i] == RangeImage::kNoRow || run.image.range[i] > 40.0f) continue;
    const Eigen::Vector3d p = run.mapPoint(i);
    const double height = (p.z() - hill.slope * p.x()) * std::cos(std::atan(hill.slope));
    ++checked;
    far += !(std::fabs(static_cast<double>(run.segmentation.heightAboveGround[i]) - height) < 0.03);
  }
  ASSERT_GT(checked, 10000);
  EXPECT_LT(far, checked / 100);
}

TEST(GroundOptionsOfTravel, LoseASteepHillAsTheOriginalDoes) {
  const Hillside hill(25.0);
  const SensorModel& sensor = sensorByName("OS0-128");
  GroundOptions travel;
  travel.minNormalZ = 0.94, travel.terrainRounds = 0;
  const auto scan = hill.scene.scan(sensor, sensorAt({0, 0, 0.6}));
  EXPECT_EQ(GroundTestRun(scan, sensor, travel).shares(Scene::Ground).ground, 0.0);
}

}  // namespace
}  // namespace toss::test
