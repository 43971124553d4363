// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/TraversabilitySearch.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace toss::test {
namespace {

const TriGridField& field() {
  static const TriGridField instance(8.0, 2.0);
  return instance;
}

/// Flat ground in all nodes, at the height that `heightOf` gives for the node's middle.
std::vector<GroundNode> flatNodes(const std::function<float(const Eigen::Vector2f&)>& heightOf) {
  std::vector<GroundNode> nodes(static_cast<std::size_t>(field().nodes()));
  for (int i = 0; i < field().nodes(); ++i) {
    GroundNode& node = nodes[static_cast<std::size_t>(i)];
    const Eigen::Vector2f middle = field().centroidOf(i);
    node.type = NodeType::Ground;
    node.mean << middle, heightOf(middle);
    node.offset = -node.mean.z();
    node.weight = 300.0f;
  }
  return nodes;
}

std::ptrdiff_t groundOf(const std::vector<GroundNode>& nodes) {
  return std::count_if(nodes.begin(), nodes.end(),
                       [](const GroundNode& node) { return node.isGround(); });
}

/// A platform, too high to step on, on one side of the field.
float platform(const Eigen::Vector2f& p) {
  return p.x() > 4.0f ? 1.0f : 0.0f;
}

TEST(TraversabilitySearch, ReachesAllOfFlatGround) {
  auto nodes = flatNodes([](const Eigen::Vector2f&) { return -1.0f; });
  searchTraversable(field(), GroundOptions{}, nodes);
  EXPECT_EQ(groundOf(nodes), field().nodes());
}

TEST(TraversabilitySearch, StopsAtAStep) {
  auto nodes = flatNodes(platform);
  GroundOptions options;
  options.islandPolicy = IslandPolicy::Reject;
  searchTraversable(field(), options, nodes);
  for (const GroundNode& node : nodes) EXPECT_EQ(node.isGround(), node.mean.x() < 4.0f);
}

TEST(TraversabilitySearch, IslandsFollowThePolicy) {
  GroundOptions options;
  const auto groundWith = [&](IslandPolicy policy, float weight) {
    auto nodes = flatNodes(platform);
    for (GroundNode& node : nodes) node.weight = node.mean.x() > 4.0f ? weight : 1000.0f;
    options.islandPolicy = policy;
    searchTraversable(field(), options, nodes);
    return std::count_if(nodes.begin(), nodes.end(), [](const GroundNode& node) {
      return node.isGround() && node.mean.x() > 4.0f;
    });
  };
  // 200 for squares of 8 m is 12.5 for those of 2 m.
  EXPECT_GT(groundWith(IslandPolicy::AcceptIfWeight, 13.0f), 0);
  EXPECT_EQ(groundWith(IslandPolicy::AcceptIfWeight, 12.0f), 0);
  EXPECT_GT(groundWith(IslandPolicy::Accept, 100.0f), 0);
  EXPECT_EQ(groundWith(IslandPolicy::Reject, 300.0f), 0);
}

TEST(TraversabilitySearch, FirstEdgeRefusesWhatAnyEdgeAccepts) {
  // A ramp beside a step: the node at its top is reached over the step first.
  const auto ramp = [](const Eigen::Vector2f& p) {
    return p.y() > 0.0f ? 0.0f : std::clamp(0.05f * p.x(), 0.0f, 1.0f) + (p.x() > 6.0f ? 0.2f : 0);
  };
  GroundOptions options;
  options.islandPolicy = IslandPolicy::Reject;
  auto any = flatNodes(ramp), first = any;
  searchTraversable(field(), options, any);
  options.edgePolicy = EdgePolicy::FirstEdge;
  searchTraversable(field(), options, first);
  EXPECT_GT(groundOf(any), groundOf(first));
  for (std::size_t i = 0; i < any.size(); ++i) {
    EXPECT_TRUE(any[i].isGround() || !first[i].isGround()) << "any edge never accepts less";
  }
}

TEST(TraversabilitySearch, NoGroundAtAllIsFine) {
  std::vector<GroundNode> nodes(static_cast<std::size_t>(field().nodes()));
  searchTraversable(field(), GroundOptions{}, nodes);
  EXPECT_EQ(groundOf(nodes), 0);
}

TEST(Traversable, TestsNormalsAndSteps) {
  const GroundOptions options;
  GroundNode a, b;
  b.mean << 2.0f, 0.0f, 0.0f;
  EXPECT_TRUE(isTraversable(a, b, options));
  // Off the plane by more than sin(0.1) of the distance.
  b.mean.z() = 0.21f;
  EXPECT_FALSE(isTraversable(a, b, options));
  b.mean.z() = 0.19f;
  EXPECT_TRUE(isTraversable(a, b, options));
  EXPECT_EQ(isTraversable(a, b, options), isTraversable(b, a, options));
  // Normals: 1 - sin(2 m * 0.03 rad/m) = 0.94, 19.9 degrees. The centres lie on either plane only
  // at distance 0, so that the second test is widened.
  GroundOptions lax = options;
  lax.convexityPlanar = 1.5;
  b.mean.z() = 0.0f;
  for (const double degrees : {19.5, 20.5}) {
    const auto angle = static_cast<float>(degrees * M_PI / 180.0);
    b.normal << 0.0f, std::sin(angle), std::cos(angle);
    EXPECT_EQ(isTraversable(a, b, lax), degrees < 20.0);
  }
}

}  // namespace
}  // namespace toss::test
