// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "GroundTestRun.h"

namespace toss::test {
namespace {

using Scene = GroundTestScene;

const SensorModel& hdl64() {
  return sensorByName("HDL-64E");
}

bool within25Metres(const Eigen::Vector3d&, double range) {
  return range < 25.0;
}

TEST(GroundFeatures, KerbIsGroundOnBothLevels) {
  Scene scene;
  scene.addGround(0.0);
  scene.addBox({-60, 4, -1}, {60, 12, 0.12}, Scene::Ground);
  const auto scan = scene.scan(hdl64(), sensorAt({0, 0, 1.73}), 1000);
  const GroundTestRun run(scan, hdl64(), GroundOptions{});
  const auto road = run.shares(Scene::Ground, [](const Eigen::Vector3d& p, double range) {
    return range < 25.0 && p.z() < 0.05;
  });
  const auto pavement = run.shares(Scene::Ground, [](const Eigen::Vector3d& p, double range) {
    return range < 25.0 && p.z() > 0.08 && p.y() > 4.5;
  });
  EXPECT_GT(road.ground, 0.98);
  EXPECT_GT(pavement.ground, 0.95);
  EXPECT_EQ(run.shares(Scene::Ground).below, 0.0);
}

TEST(GroundFeatures, StairsAreGroundAndKeepAPersonOut) {
  Scene scene;
  scene.addGround(0.0);
  for (int step = 0; step < 20; ++step) {
    const double x = 3.0 + 0.3 * step;
    scene.addBox({x, -4, -1}, {x + 30.0, 4, 0.16 * (step + 1)}, Scene::Ground);
  }
  scene.addBox({5.4, -0.3, 0.0}, {5.9, 0.3, 3.1}, Scene::Object);
  const SensorModel& sensor = sensorByName("OS0-128");
  const auto scan = scene.scan(sensor, sensorAt({0, 0, 0.8}));
  GroundOptions options;
  options.extent = 30.0, options.cellSize = 4.0;
  const GroundTestRun run(scan, sensor, options);
  const GroundShares person = run.shares(Scene::Object);
  ASSERT_GT(person.count, 100);
  EXPECT_LT(person.ground, 0.1);
  const auto floor = run.shares(Scene::Ground, [](const Eigen::Vector3d& p, double range) {
    return range < 12.0 && (p.x() < 2.5 || std::fabs(p.y()) > 4.2);
  });
  EXPECT_GT(floor.ground, 0.95);
  EXPECT_EQ(run.shares(Scene::Ground).below, 0.0);
}

TEST(GroundFeatures, MirrorReturnsDoNotPullTheGroundDown) {
  Scene scene;
  scene.addGround(0.0);
  auto scan = scene.scan(hdl64(), sensorAt({0, 0, 1.73}), 1000);
  // A car's reflection in a wet road: a patch of returns 1.2 m under it, on every twentieth beam.
  const PointCloud clean = scan.posed.points;
  for (std::size_t i = 0; i < clean.size(); i += 20) {
    const Eigen::Vector3d p(clean.x[i], clean.y[i], clean.z[i]);
    if (p.x() < 6.0 || p.x() > 20.0 || std::fabs(p.y()) > 6.0) continue;
    Scene::append(scan, p * (2.93 / 1.73), clean.ring[i], Scene::Nothing);
  }
  const GroundTestRun run(scan, hdl64(), GroundOptions{});
  const GroundShares mirrored = run.shares(Scene::Nothing);
  ASSERT_GT(mirrored.count, 100);
  EXPECT_EQ(mirrored.ground, 0.0);
  EXPECT_GT(mirrored.below, 0.95);
  EXPECT_GT(run.shares(Scene::Ground, within25Metres).ground, 0.99);
}

TEST(GroundFeatures, DitchIsNotCutOutOfTheMap) {
  Scene scene;
  scene.addGround(0.0, 0.0, 0.0, [](double x, double) { return x < 7.0 || x > 13.0; });
  scene.addGround(-0.6, 0.0, 0.0, [](double x, double) { return x >= 7.0 && x <= 13.0; });
  scene.addBox({13, -80, -0.6}, {13.1, 80, -0.001}, Scene::Ground);
  const auto scan = scene.scan(hdl64(), sensorAt({0, 0, 1.73}), 1000);
  const GroundTestRun run(scan, hdl64(), GroundOptions{});
  const auto ditch = run.shares(Scene::Ground, [](const Eigen::Vector3d& p, double) {
    return p.z() < -0.1 && std::fabs(p.y()) < 10.0;
  });
  ASSERT_GT(ditch.count, 100);
  EXPECT_LT(ditch.below, 0.05);
}

TEST(GroundFeatures, RoofsAreNotGround) {
  Scene scene;
  scene.addGround(0.0);
  // A lorry that hides the road under it, with a flat roof seen from above by a high sensor.
  scene.addBox({6, -3, 0.0}, {18, 3, 2.2}, Scene::Object);
  const auto scan = scene.scan(hdl64(), sensorAt({0, 0, 4.0}), 1000);
  const GroundShares lorry = GroundTestRun(scan, hdl64(), GroundOptions{}).shares(Scene::Object);
  ASSERT_GT(lorry.count, 1000);
  EXPECT_LT(lorry.ground, 0.02);
}

TEST(GroundFeatures, NothingOutsideTheContractIsTouched) {
  Scene scene;
  scene.addGround(0.0);
  auto scan = scene.scan(hdl64(), sensorAt({0, 0, 1.73}), 360);
  Scene::append(scan, {std::nan(""), 0, 0}, 0, Scene::Nothing);
  Scene::append(scan, {0, 0, 0}, 0, Scene::Nothing);
  Scene::append(scan, {200, 0, -1.7}, 0, Scene::Nothing);
  const GroundTestRun run(scan, hdl64(), GroundOptions{});
  const std::size_t n = run.scan.surface.size();
  EXPECT_EQ(run.segmentation.pointClass[n - 3], PointClass::Invalid);
  EXPECT_EQ(run.segmentation.pointClass[n - 2], PointClass::Invalid);
  EXPECT_EQ(run.segmentation.pointClass[n - 1], PointClass::OutOfRange);
}

TEST(GroundFeatures, AScanWithoutPointsIsFine) {
  const GroundTestRun run(Scene().scan(hdl64(), sensorAt({0, 0, 1})), hdl64(), GroundOptions{});
  EXPECT_TRUE(run.segmentation.pointClass.empty());
}

}  // namespace
}  // namespace toss::test
