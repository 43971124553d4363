// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/GroundMemory.h>
#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/TriGridField.h>

#include <cmath>
#include <limits>

namespace toss::test {
namespace {

using Eigen::Vector3d;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kExtent = 64.0;

/// Level ground at `height` [m, level frame] up to 10 m from the sensor along either axis.
NearbyGround spotAt(float height) {
  const TriGridField field(kExtent, 2.0);
  std::vector<GroundNode> nodes(static_cast<std::size_t>(field.nodes()));
  for (int n = 0; n < field.nodes(); ++n) {
    if (field.centroidOf(n).cwiseAbs().maxCoeff() > 10.0f) continue;
    nodes[static_cast<std::size_t>(n)].type = NodeType::Ground;
    nodes[static_cast<std::size_t>(n)].offset = -height;
  }
  NearbyGround ground;
  ground.assign(field, nodes);
  return ground;
}

/// What is known of a place seen from a sensor, both in the map frame.
double heightAt(const GroundMemory& memory, const Vector3d& place, const Vector3d& sensor) {
  NearbyGround ground;
  memory.recall(sensor, kExtent, ground);
  const Eigen::Vector2f p = (place - sensor).head<2>().cast<float>();
  return sensor.z() + static_cast<double>(ground.highest(p.x(), p.y()));
}

TEST(GroundMemory, KnowsFromAfarWhatWasKnownNearby) {
  for (const Vector3d& origin : {Vector3d(0, 0, 0), Vector3d(-4.0e5, 5.5e6, 300.0)}) {
    GroundMemory memory;
    for (const double x : {0.0, 37.0}) memory.add(x, origin + Vector3d(x, 0, 2), spotAt(-1.7f));
    const Vector3d robot = origin + Vector3d(-43, 20, 5);
    for (const double x : {-6.0, 0.0, 6.0, 31.0, 43.0})
      EXPECT_NEAR(origin.z() + 0.3, heightAt(memory, origin + Vector3d(x, 0, 0), robot), 1e-4) << x;
    EXPECT_GT(heightAt(memory, origin + Vector3d(20, 0, 0), robot), origin.z() + 2.0)
        << "carried on between them";
  }
}

TEST(GroundMemory, TheMeanOfTheLastScansCounts) {
  GroundMemory memory;
  const Vector3d robot(3, 5, 0);
  const auto knownAfter = [&](double time, float height) {
    memory.add(time, robot, spotAt(height));
    return heightAt(memory, robot, robot);
  };
  EXPECT_NEAR(1.0, knownAfter(0.0, 1.0f), 1e-5) << "a hedge";
  EXPECT_LT(knownAfter(0.1, -2.0f), 1.0);
  for (int scan = 2; scan < 30; ++scan) knownAfter(0.1 * scan, -2.0f);
  EXPECT_NEAR(-2.0, knownAfter(3.0, -2.0f), 0.01) << "outnumbered";
  EXPECT_NEAR(-2.0, knownAfter(5.0, 1.0f), 0.7);
  EXPECT_NEAR(4.0, knownAfter(60.0, 4.0f), 1e-5) << "back on the next floor of a car park";
}

TEST(GroundMemory, KeepsNoMoreThanASquareKilometre) {
  GroundMemory memory;
  EXPECT_EQ(kInfinity, heightAt(memory, Vector3d::Zero(), Vector3d::Zero()));
  memory.add(0.0, Vector3d::Zero(), spotAt(-1.0f));
  EXPECT_EQ(kInfinity, heightAt(memory, Vector3d(1024, 0, 0), Vector3d(1024, 0, 0)));
  EXPECT_NEAR(-1.0, heightAt(memory, Vector3d::Zero(), Vector3d::Zero()), 1e-5);
  memory.add(1.0, Vector3d(1024, -1024, 0), spotAt(-2.0f));
  EXPECT_EQ(kInfinity, heightAt(memory, Vector3d::Zero(), Vector3d::Zero()));
}

}  // namespace
}  // namespace toss::test
