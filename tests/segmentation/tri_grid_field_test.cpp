// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/segmentation/TriGridField.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace toss::test {
namespace {

const TriGridField& field() {
  static const TriGridField instance(16.0, 4.0);
  return instance;
}

/// Twice the signed area of a triangle.
float area(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

std::set<std::pair<float, float>> cornersOf(int node) {
  std::set<std::pair<float, float>> corners;
  for (const int vertex : field().verticesOf(node)) {
    corners.insert({field().vertexPosition(vertex).x(), field().vertexPosition(vertex).y()});
  }
  return corners;
}

TEST(TriGridField, APositionLiesInTheTriangleOfItsNode) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(-15.99f, 15.99f);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2f p(anywhere(random), anywhere(random));
    const int node = field().nodeOf(p.x(), p.y());
    ASSERT_GE(node, 0);
    const auto v = field().verticesOf(node);
    for (std::size_t k = 0; k < 3; ++k) {
      // Counter-clockwise triangles hold what lies left of each of their edges.
      ASSERT_GE(area(field().vertexPosition(v[k]), field().vertexPosition(v[(k + 1) % 3]), p),
                -1e-3f);
    }
  }
}

TEST(TriGridField, PositionsOutsideHaveNoNode) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float outside : {16.0f, -16.01f, 1e30f, -1e30f, nan, infinity, -infinity}) {
    EXPECT_EQ(field().nodeOf(outside, 0.0f), -1);
    EXPECT_EQ(field().nodeOf(0.0f, outside), -1);
  }
}

TEST(TriGridField, NeighboursAreTheTrianglesThatShareACorner) {
  for (int a = 0; a < field().nodes(); ++a) {
    std::vector<int> expected;
    const auto cornersOfA = cornersOf(a);
    for (int b = 0; b < field().nodes(); ++b) {
      bool shared = false;
      for (const auto& corner : cornersOf(b)) shared |= cornersOfA.count(corner) > 0;
      if (shared && a != b) expected.push_back(b);
    }
    const std::vector<int> actual(field().neighboursBegin(a), field().neighboursEnd(a));
    ASSERT_EQ(actual, expected) << "node " << a;
  }
}

TEST(TriGridField, InnerNodesHaveFourteenNeighbours) {
  const int inner = field().nodeOf(0.5f, 0.1f);
  EXPECT_EQ(field().neighboursEnd(inner) - field().neighboursBegin(inner), 14);
}

TEST(TriGridField, FinerNodesLieInSingleCoarseNodes) {
  for (const int factor : {2, 3, 4}) {
    const TriGridField fine = field().refined(factor);
    EXPECT_EQ(fine.nodes(), factor * factor * field().nodes());
    EXPECT_FLOAT_EQ(fine.extent(), field().extent());
    for (int node = 0; node < fine.nodes(); ++node) {
      const Eigen::Vector2f middle = fine.centroidOf(node);
      const int outer = field().nodeOf(middle.x(), middle.y());
      for (const int vertex : fine.verticesOf(node)) {
        // A bit inwards of each vertex, to be off the border.
        const Eigen::Vector2f p = 0.99f * fine.vertexPosition(vertex) + 0.01f * middle;
        ASSERT_EQ(field().nodeOf(p.x(), p.y()), outer);
      }
    }
  }
}

TEST(TriGridField, RingsCountSquaresFromTheSensor) {
  EXPECT_EQ(field().ringOf(field().nodeOf(0.1f, -0.1f)), 0);
  EXPECT_EQ(field().ringOf(field().nodeOf(3.9f, -3.9f)), 0);
  EXPECT_EQ(field().ringOf(field().nodeOf(4.1f, 0.0f)), 1);
  EXPECT_EQ(field().ringOf(field().nodeOf(0.0f, -15.0f)), 3);
}

}  // namespace
}  // namespace toss::test
