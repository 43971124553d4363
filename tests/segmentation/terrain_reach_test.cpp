// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "GroundTestRun.h"

namespace toss::test {
namespace {

using Scene = GroundTestScene;

/// Distance from which on a VLP-16 at 1.8 m meets flat ground in rings that are far apart, and up
/// to which they are carried on [m].
constexpr double kRings = 16.0, kFarRings = 30.0;

GroundTestRun scanned(const Scene& scene, int reachRounds, const std::string& model = "VLP-16") {
  GroundOptions options;
  options.reachRounds = reachRounds;
  const SensorModel& sensor = sensorByName(model);
  return {scene.scan(sensor, sensorAt({0, 0, 1.8}), sensor.columns), sensor, options};
}

GroundShares inRings(const GroundTestRun& run, Scene::Surface surface) {
  return run.shares(surface, [](const Eigen::Vector3d& p, double) {
    return p.head<2>().norm() > kRings && p.head<2>().norm() < kFarRings;
  });
}

Scene squareWithPeople(double slope) {
  Scene scene;
  scene.addGround(0.0, slope, 0.5 * slope);
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector2d at = (18.0 + 0.9 * i) * Eigen::Rotation2Dd(0.52 * i).toRotationMatrix() *
                               Eigen::Vector2d::UnitX();
    const Eigen::Vector3d foot(at.x(), at.y(), slope * (at.x() + 0.5 * at.y()));
    scene.addBox(foot - Eigen::Vector3d(0.25, 0.25, 0.1), foot + Eigen::Vector3d(0.25, 0.25, 1.7),
                 Scene::Object);
  }
  return scene;
}

TEST(TerrainReach, SingleRingsOnASlopeAreGroundAndPeopleInThemAreNot) {
  for (const double slope : {0.0, 0.05}) {
    const Scene scene = squareWithPeople(slope);
    const GroundTestRun run = scanned(scene, GroundOptions().reachRounds);
    ASSERT_GT(inRings(run, Scene::Ground).count, 1000);
    EXPECT_GT(inRings(run, Scene::Ground).ground, 0.95) << "slope " << slope;
    EXPECT_LT(inRings(scanned(scene, 0), Scene::Ground).ground, 0.7) << "slope " << slope;
    ASSERT_GT(inRings(run, Scene::Object).count, 100);
    EXPECT_LT(inRings(run, Scene::Object).ground, 0.06) << "slope " << slope;
    EXPECT_LT(inRings(run, Scene::Ground).below, 1e-3) << "slope " << slope;
  }
}

TEST(TerrainReach, DenserRowsMeetSingleRingsFartherOut) {
  Scene scene;
  scene.addGround(0.0, 0.02, 0.01);
  const auto share = [&](int reachRounds) {
    return scanned(scene, reachRounds, "OS1-64")
        .shares(Scene::Ground,
                [](const Eigen::Vector3d& p, double) {
                  return p.head<2>().norm() > 25.0 && p.head<2>().norm() < 40.0;
                })
        .ground;
  };
  EXPECT_GT(share(GroundOptions().reachRounds), 0.95);
  EXPECT_LT(share(0), 0.7);
}

TEST(TerrainReach, NothingIsCarriedOnOverALowerTerrace) {
  Scene scene;
  scene.addGround(0.0, 0.0, 0.0, [](double x, double) { return x < 12.0; });
  scene.addGround(-1.0, 0.0, 0.0, [](double x, double) { return x >= 12.0; });
  const GroundTestRun run = scanned(scene, GroundOptions().reachRounds);
  const GroundShares lower =
      run.shares(Scene::Ground, [](const Eigen::Vector3d& p, double) { return p.x() > kRings; });
  ASSERT_GT(lower.count, 200);
  EXPECT_EQ(0.0, lower.below);
}

TEST(TerrainReach, SensorsOfManyRowsDoNotNeedIt) {
  const Scene scene = squareWithPeople(0.05);
  const SensorModel& sensor = sensorByName("HDL-64E");
  const auto scan = scene.scan(sensor, sensorAt({0, 0, 1.8}), sensor.columns / 4);
  GroundOptions without;
  without.reachRounds = 0;
  EXPECT_EQ(GroundTestRun(scan, sensor, GroundOptions()).segmentation.pointClass,
            GroundTestRun(scan, sensor, without).segmentation.pointClass);
}

}  // namespace
}  // namespace toss::test
