// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/render/Extent.h>

#include <limits>
#include <random>

namespace toss {
namespace {

std::vector<MapPoint> uniformMap(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> x(0.0f, 200.0f), y(-50.0f, 50.0f), z(-2.0f, 8.0f);
  std::vector<MapPoint> points(count);
  for (MapPoint& point : points) point = {x(random), y(random), z(random), 0.5f};
  return points;
}

TEST(ExtentTest, OfAMapWithoutOutliersIsItsBox) {
  const auto points = uniformMap(50000);
  const Extent full = fullExtent(points), robust = robustExtent(points);
  EXPECT_TRUE(robust.low.isApprox(full.low, 1e-9));
  EXPECT_TRUE(robust.high.isApprox(full.high, 1e-9));
}

TEST(ExtentTest, OutliersDoNotCount) {
  auto points = uniformMap(50000);
  const Extent clean = robustExtent(points);
  for (int i = 0; i < 50; ++i) points.push_back({5000.0f, -9000.0f, -300.0f, 1.0f});
  points.push_back({std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f, 0.0f});
  const Extent robust = robustExtent(points);
  EXPECT_LT((robust.low - clean.low).norm(), 4.0);
  EXPECT_LT((robust.high - clean.high).norm(), 4.0);
  EXPECT_EQ(fullExtent(points).high.x(), 5000.0);
}

TEST(ExtentTest, OfFewPointsHoldsThemAll) {
  const Extent extent = robustExtent({{1, 5, 0, 0}, {4, 2, 7, 0}});
  EXPECT_EQ(extent.low, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(extent.high, Eigen::Vector3d(4, 5, 7));
  EXPECT_EQ(robustExtent({}).size().norm(), 0.0);
}

TEST(ExtentTest, OutlineHoldsEveryPointInside) {
  const auto points = uniformMap(5000);
  const Extent extent{{20, -30, -1}, {180, 30, 5}};
  const auto outline = outlineOf(points, extent);
  ASSERT_FALSE(outline.empty());
  // A plane of any direction that has the outline on one side has the points on that side too.
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d direction(normal(random), normal(random), normal(random));
    double farthest = -1e9, farthestOutline = -1e9;
    for (const Eigen::Vector3d& corner : outline)
      farthestOutline = std::max(farthestOutline, corner.dot(direction));
    for (const MapPoint& point : points) {
      const Eigen::Vector3d position(point.x, point.y, point.z);
      if (extent.contains(position)) farthest = std::max(farthest, position.dot(direction));
    }
    EXPECT_LE(farthest, farthestOutline + 1e-9);
  }
}

TEST(ValueRangeTest, IsThatOfMostPoints) {
  auto points = uniformMap(50000);
  for (int i = 0; i < 500; ++i) points.push_back({0.0f, 0.0f, 1000.0f, 100.0f});
  const ValueRange height = heightRange(points);
  EXPECT_NEAR(height.low, -1.8f, 0.1f);
  EXPECT_NEAR(height.high, 7.9f, 0.2f);
  EXPECT_EQ(height.position(-100.0f), 0.0f);
  EXPECT_EQ(height.position(100.0f), 1.0f);
  // All the same: still a range.
  const ValueRange intensity = intensityRange(points);
  EXPECT_LT(intensity.low, intensity.high);
}

}  // namespace
}  // namespace toss
