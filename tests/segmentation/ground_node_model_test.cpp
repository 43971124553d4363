// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/GroundNodeFit.h>

#include <cmath>
#include <random>

namespace toss::test {
namespace {

/// Returns of one node, grown piece by piece.
struct NodeReturns {
  std::vector<NodePoint> returns;
  std::mt19937 random{11};

  /// `count` returns on z = height + slope x over 4 m x 4 m, with a thickness of `spread`.
  NodeReturns& plane(int count, float height, float slope = 0.0f, float spread = 0.01f) {
    std::uniform_real_distribution<float> place(10.0f, 14.0f), off(-spread, spread);
    for (int i = 0; i < count; ++i) {
      const float x = place(random), y = place(random);
      returns.push_back({x, y, height + slope * (x - 12.0f) + off(random), i});
    }
    return *this;
  }
  /// A wall at x = 13 from z = 0 up.
  NodeReturns& wall(int count, float top) {
    std::uniform_real_distribution<float> place(10.0f, 14.0f), height(0.0f, top);
    for (int i = 0; i < count; ++i) {
      const float y = place(random), z = height(random);
      returns.push_back({13.0f, y, z, i});
    }
    return *this;
  }
  NodePoints points() const { return {returns.data(), returns.size()}; }
};

TEST(GroundNodeModel, FitsTheLowerOfTwoSurfaces) {
  const NodeReturns returns = NodeReturns().plane(200, -1.7f, 0.1f).plane(100, 0.3f);
  const GroundNode node = GroundNodeFit(GroundOptions{}).fit(returns.points());
  EXPECT_TRUE(node.isGround());
  EXPECT_NEAR(node.normal.x() / node.normal.z(), -0.1, 0.005);
  EXPECT_NEAR(node.heightOf(12.0f, 12.0f, -1.7f), 0.0, 0.01);
}

TEST(GroundNodeModel, SlopeLimitIsTheNormals) {
  GroundOptions options;
  options.minNormalZ = std::cos(30.0 * M_PI / 180.0);
  for (const double degrees : {27.0, 33.0}) {
    const auto slope = static_cast<float>(std::tan(degrees * M_PI / 180.0));
    const NodeReturns returns = NodeReturns().plane(400, 0.0f, slope);
    EXPECT_EQ(GroundNodeFit(options).fit(returns.points()).isGround(), degrees < 30.0);
  }
}

TEST(GroundNodeModel, AWallIsNotGround) {
  EXPECT_FALSE(
      GroundNodeFit(GroundOptions{}).fit(NodeReturns().wall(300, 3.0f).points()).isGround());
}

TEST(GroundNodeModel, FewReturnsTellNothing) {
  const NodeReturns returns = NodeReturns().plane(9, 0.0f);
  EXPECT_EQ(GroundNodeFit(GroundOptions{}).fit(returns.points()).type, NodeType::Unknown);
}

TEST(GroundNodeModel, ReflectionsUnderTheRoadAreSkipped) {
  const NodeReturns returns = NodeReturns().plane(300, -1.7f).plane(12, -3.2f, 0.0f, 0.2f);
  EXPECT_NEAR(GroundNodeFit(GroundOptions{}).lowestLayer(returns.points()), -1.7, 0.05);
  EXPECT_NEAR(GroundNodeFit(GroundOptions{}).fit(returns.points()).mean.z(), -1.7, 0.02);
  GroundOptions trusting;
  trusting.minLayerShare = 0.0;
  EXPECT_LT(GroundNodeFit(trusting).lowestLayer(returns.points()), -3.0);
}

TEST(GroundNodeModel, LittleGroundInFrontOfAWallIsNoReflection) {
  // A wall goes on from the ground without a gap.
  const NodeReturns returns = NodeReturns().plane(12, 0.0f).wall(600, 6.0f);
  EXPECT_NEAR(GroundNodeFit(GroundOptions{}).lowestLayer(returns.points()), 0.0, 0.03);
}

TEST(GroundNodeModel, APickOfTheReturnsFitsTheSamePlane) {
  const NodeReturns returns = NodeReturns().plane(6000, -1.7f, 0.2f, 0.03f);
  GroundOptions all;
  all.maxFitPoints = 0;
  const GroundNode exact = GroundNodeFit(all).fit(returns.points());
  const GroundNode picked = GroundNodeFit(GroundOptions{}).fit(returns.points());
  EXPECT_GT(exact.normal.dot(picked.normal), 0.99999f);
  EXPECT_NEAR(exact.heightOf(12, 12, 0), picked.heightOf(12, 12, 0), 0.005f);
}

}  // namespace
}  // namespace toss::test
