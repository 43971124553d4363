// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/TerrainFit.h>

#include <cmath>
#include <limits>
#include <random>

namespace toss::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

const TriGridField& field() {
  static const TriGridField instance(8.0, 2.0);
  return instance;
}

float truth(const Eigen::Vector2f& p) {
  return 0.3f + 0.2f * p.x() - 0.1f * p.y();
}

VertexHeights heightsOf(float (*height)(const Eigen::Vector2f&)) {
  VertexHeights heights;
  for (int v = 0; v < field().vertices(); ++v) {
    heights.push_back(height(field().vertexPosition(v)));
  }
  return heights;
}

/// Returns scattered over one node at the given offset from the true plane.
struct Scatter {
  std::vector<NodePoint> returns;
  Scatter(int node, int count, float offset) {
    std::mt19937 random(static_cast<unsigned>(node));
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    const auto v = field().verticesOf(node);
    while (static_cast<int>(returns.size()) < count) {
      const float a = share(random), b = share(random);
      if (a + b > 1.0f) continue;
      const Eigen::Vector2f p = a * field().vertexPosition(v[0]) +
                                b * field().vertexPosition(v[1]) +
                                (1.0f - a - b) * field().vertexPosition(v[2]);
      returns.push_back({p.x(), p.y(), truth(p) + offset, 0});
    }
  }
  NodePoints points() const { return {returns.data(), returns.size()}; }
};

TEST(TerrainFit, FindsThePlaneThatAllReturnsLieOn) {
  TerrainFit fit(field());
  VertexHeights heights = heightsOf(truth);
  std::mt19937 random(4);
  std::normal_distribution<float> error(0.0f, 0.05f);
  for (float& height : heights) height += error(random);
  for (int round = 0; round < 4; ++round) {
    fit.clear();
    for (int node = 0; node < field().nodes(); ++node) {
      fit.add(node, Scatter(node, 40, 0.0f).points(), heights, 0.4f, nullptr);
    }
    fit.solve(heights);
  }
  for (int v = 0; v < field().vertices(); ++v) {
    EXPECT_NEAR(heights[static_cast<std::size_t>(v)], truth(field().vertexPosition(v)), 0.01f);
  }
}

TEST(TerrainFit, IgnoresWhatStandsOnTheGround) {
  TerrainFit fit(field());
  VertexHeights heights = heightsOf(truth);
  fit.clear();
  for (int node = 0; node < field().nodes(); ++node) {
    fit.add(node, Scatter(node, 20, 0.0f).points(), heights, 0.4f, nullptr);
    fit.add(node, Scatter(node, 60, 0.3f).points(), heights, 0.4f, nullptr);
  }
  fit.solve(heights);
  for (int v = 0; v < field().vertices(); ++v) {
    EXPECT_NEAR(heights[static_cast<std::size_t>(v)], truth(field().vertexPosition(v)), 1e-3f);
  }
}

TEST(TerrainFit, ExtendsStraightOn) {
  TerrainFit fit(field());
  VertexHeights heights = heightsOf(truth);
  int unknown = 0;
  for (int v = 0; v < field().vertices(); ++v) {
    if (field().vertexPosition(v).x() > 2.5f)
      heights[static_cast<std::size_t>(v)] = kNan, ++unknown;
  }
  for (int i = 0; i < 8; ++i) fit.extend(heights);
  int extended = 0;
  for (int v = 0; v < field().vertices(); ++v) {
    const float height = heights[static_cast<std::size_t>(v)];
    if (std::isnan(height)) continue;
    EXPECT_NEAR(height, truth(field().vertexPosition(v)), 1e-4f);
    extended += field().vertexPosition(v).x() > 2.5f;
  }
  EXPECT_GT(extended, unknown / 2);
}

TEST(TerrainFit, LeavesUnknownVerticesUnknown) {
  TerrainFit fit(field());
  VertexHeights heights(static_cast<std::size_t>(field().vertices()), kNan);
  fit.clear();
  fit.add(0, Scatter(0, 10, 0.0f).points(), heights, 0.4f, nullptr);
  fit.solve(heights);
  for (const float height : heights) EXPECT_TRUE(std::isnan(height));
}

TEST(TerrainRefinement, RevivesATriangleBetweenGround) {
  std::vector<GroundNode> nodes(static_cast<std::size_t>(field().nodes()));
  for (int i = 0; i < field().nodes(); ++i) {
    GroundNode& node = nodes[static_cast<std::size_t>(i)];
    node.type = NodeType::Ground;
    node.normal = Eigen::Vector3f(-0.2f, 0.1f, 1.0f).normalized();
    node.mean << field().centroidOf(i), truth(field().centroidOf(i));
    node.offset = -node.normal.dot(node.mean);
    node.weight = 1.0f + static_cast<float>(i % 7);
  }
  const auto revived = static_cast<std::size_t>(field().nodeOf(0.9f, 0.2f));
  nodes[revived] = GroundNode{};
  nodes[revived].type = NodeType::NonGround;
  VertexHeights heights;
  averageVertices(field(), nodes, heights);
  replacePlanes(field(), GroundOptions{}, heights, nodes);
  EXPECT_TRUE(nodes[revived].isGround());
  EXPECT_NEAR(nodes[revived].heightOf(0.9f, 0.2f, truth({0.9f, 0.2f})), 0.0f, 1e-5f);
}

TEST(TerrainRefinement, SteepAndUnknownTrianglesAreNotGround) {
  VertexHeights heights = heightsOf([](const Eigen::Vector2f& p) { return 2.0f * p.x(); });
  GroundNode node;
  replacePlane(field(), GroundOptions{}, heights, 0, node);
  EXPECT_EQ(node.type, NodeType::NonGround);
  heights.assign(heights.size(), kNan);
  node.type = NodeType::Ground;
  replacePlane(field(), GroundOptions{}, heights, 0, node);
  EXPECT_EQ(node.type, NodeType::Unknown);
}

}  // namespace
}  // namespace toss::test
