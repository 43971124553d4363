// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "GroundTestRun.h"

namespace toss::test {
namespace {

using Scene = GroundTestScene;

struct Setup {
  const char* sensor;
  /// Height of the sensor over the ground [m], and distance up to which its beams are dense [m].
  double height, dense;
};

void PrintTo(const Setup& setup, std::ostream* out) {
  *out << setup.sensor << " at " << setup.height << " m";
}

class GroundOfSensor : public testing::TestWithParam<Setup> {};

/// A gently sloping square with people on it and a house at its end.
TEST_P(GroundOfSensor, IsFoundByTheDefaults) {
  const auto [name, height, dense] = GetParam();
  const double slope = 0.05, reach = dense;
  Scene scene;
  scene.addGround(0.0, slope);
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.63 * i + 0.2, distance = 0.3 * dense + 0.06 * dense * i;
    const Eigen::Vector3d foot(distance * std::cos(angle), distance * std::sin(angle), 0.0);
    scene.addBox(foot + Eigen::Vector3d(-0.2, -0.2, slope * foot.x() - 0.1),
                 foot + Eigen::Vector3d(0.2, 0.2, slope * foot.x() + 1.7), Scene::Object);
  }
  scene.addBox({dense + 2.0, -20, -5}, {dense + 12.0, 20, 10}, Scene::Object);
  const SensorModel& sensor = sensorByName(name);
  const auto scan = scene.scan(sensor, sensorAt({0, 0, height}), sensor.columns);
  const GroundTestRun run(scan, sensor, GroundOptions{});
  const GroundShares near = run.shares(
      Scene::Ground, [&](const Eigen::Vector3d&, double range) { return range < reach; });
  ASSERT_GT(near.count, 1000);
  EXPECT_GT(near.ground, 0.98);
  // The lowest beam on the house behind, alone in its triangles, can't be told from rising ground.
  const GroundShares people = run.shares(
      Scene::Object, [&](const Eigen::Vector3d& p, double) { return p.x() < reach + 1.9; });
  ASSERT_GT(people.count, 50);
  EXPECT_LT(people.ground, 0.06);
  EXPECT_LT(run.shares(Scene::Ground).below, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Sensors, GroundOfSensor,
                         testing::Values(Setup{"HDL-64E", 1.73, 40.0}, Setup{"HDL-32E", 1.8, 20.0},
                                         Setup{"VLP-16", 0.7, 12.0}, Setup{"VLP-16", 1.8, 12.0},
                                         Setup{"OS0-128", 0.5, 20.0}, Setup{"OS1-64", 1.0, 25.0}));

}  // namespace
}  // namespace toss::test
