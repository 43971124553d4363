// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/NearbyGround.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/segmentation/TriGridField.h>

#include <cmath>
#include <functional>
#include <limits>

namespace toss::test {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
const TriGridField kField(64.0, 2.0);

/// Ground at the heights that `height` gives to the middles of triangles, none where that is NaN.
NearbyGround groundWhere(const std::function<float(const Eigen::Vector2f&)>& height) {
  std::vector<GroundNode> nodes(static_cast<std::size_t>(kField.nodes()));
  for (int n = 0; n < kField.nodes(); ++n) {
    GroundNode& node = nodes[static_cast<std::size_t>(n)];
    const float z = height(kField.centroidOf(n));
    if (std::isnan(z)) continue;
    node.type = NodeType::Ground;
    node.offset = -z;
  }
  NearbyGround ground;
  ground.assign(kField, nodes);
  return ground;
}

TEST(NearbyGround, IsTheGroundItselfWhereItIsKnown) {
  const NearbyGround terraces =
      groundWhere([](const Eigen::Vector2f& p) { return p.x() < 0.0f ? -1.7f : 6.0f; });
  for (const float y : {-63.0f, -2.0f, 40.0f}) {
    EXPECT_FLOAT_EQ(-1.7f, terraces.highest(-0.5f, y));
    EXPECT_FLOAT_EQ(6.0f, terraces.highest(0.5f, y)) << "however low it is right beside";
  }
}

TEST(NearbyGround, RisesLikeStairsFromItsEdge) {
  const NearbyGround street = groundWhere(
      [](const Eigen::Vector2f& p) { return std::fabs(p.y()) < 8.0f ? -1.7f : kUnknown; });
  for (const float distance : {5.0f, 21.0f, 53.0f, 85.0f}) {
    // Heights are those of squares of 4 m, at their far side.
    const float rise = 0.5f * (distance + 2.0f);
    EXPECT_NEAR(-1.7f + rise, street.highest(10.0f, 8.0f + distance), 1.01f);
    EXPECT_NEAR(-1.7f + rise, street.highest(10.0f, -8.0f - distance), 1.01f);
  }
}

TEST(NearbyGround, RisesEquallyInAllDirections) {
  const NearbyGround spot =
      groundWhere([](const Eigen::Vector2f& p) { return p.norm() < 3.0f ? -2.0f : kUnknown; });
  for (double angle = 0.0; angle < 2.0 * M_PI; angle += 0.05) {
    for (const double distance : {20.0, 40.0, 60.0}) {
      const auto x = static_cast<float>(distance * std::cos(angle)),
                 y = static_cast<float>(distance * std::sin(angle));
      // Of steps along rows, columns and diagonals none are 9 % longer than straight ones.
      EXPECT_NEAR(-2.0 + 0.5 * 1.04 * distance, spot.highest(x, y), 0.025 * distance + 2.0);
    }
  }
}

TEST(NearbyGround, SaysNothingWithoutAnyGroundOrFarFromIt) {
  const NearbyGround none = groundWhere([](const Eigen::Vector2f&) { return kUnknown; });
  EXPECT_EQ(std::numeric_limits<float>::infinity(), none.highest(0.0f, 0.0f));
  EXPECT_EQ(std::numeric_limits<float>::infinity(), NearbyGround().highest(0.0f, 0.0f));
  const NearbyGround flat = groundWhere([](const Eigen::Vector2f&) { return 0.0f; });
  EXPECT_TRUE(std::isfinite(flat.highest(95.0f, -95.0f)));
  EXPECT_EQ(std::numeric_limits<float>::infinity(), flat.highest(101.0f, 0.0f));
  EXPECT_EQ(std::numeric_limits<float>::infinity(), flat.highest(kUnknown, 0.0f));
}

/// Instance 1 is two returns of these heights beside a street, 12 m from its edge; `known`: over
/// the ground below them.
bool floats(float low, float high, float known = kUnknown) {
  LevelPoints points;
  points.x = {0.0f, 0.0f}, points.y = {20.5f, 20.5f}, points.z = {low, high};
  Segmentation segmentation;
  segmentation.instanceCount = 1;
  segmentation.members = {0, 1}, segmentation.memberBegin = {0, 2};
  segmentation.heightAboveGround = {known, known + high - low};
  segmentation.nearbyGround = groundWhere(
      [](const Eigen::Vector2f& p) { return std::fabs(p.y()) < 8.0f ? -1.7f : kUnknown; });
  return isFloating(1, 2.5f, points, segmentation);
}

TEST(Floating, IsWhatStandsOnNoGroundThatThereMayBe) {
  EXPECT_TRUE(floats(9.0f, 12.0f)) << "a crown";
  EXPECT_FALSE(floats(3.0f, 5.0f)) << "it may stand on a slope";
  EXPECT_FALSE(floats(-1.0f, 12.0f)) << "a tree";
  EXPECT_FALSE(floats(9.0f, 12.0f, 0.5f)) << "on a terrace that is seen";
  EXPECT_TRUE(floats(3.0f, 5.0f, 4.5f)) << "over ground that is seen";
}

}  // namespace
}  // namespace toss::test
