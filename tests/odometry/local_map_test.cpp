// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/odometry/Downsampling.h>
#include <toss/odometry/LocalMap.h>

#include <cmath>
#include <random>

namespace toss::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;
const Eigen::Vector3d kUp = Eigen::Vector3d::UnitZ();

/// Points within `half` [m] of `center` on each axis.
Points randomPoints(std::size_t count, const Eigen::Vector3d& half,
                    const Eigen::Vector3d& center = Eigen::Vector3d::Zero()) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(
        center + half.cwiseProduct(Eigen::Vector3d(share(random), share(random), share(random))));
  return points;
}

TEST(Downsampling, KeepsTheFirstPointOfEachVoxel) {
  Points result;
  downsample({{0.1, 0, 0}, {0.9, 0, 0}, {-0.1, 0, 0}, {1.5, 0, 0}, {0.2, 0.3, 0.4}}, 1.0, result);
  EXPECT_EQ(result, (Points{{0.1, 0, 0}, {-0.1, 0, 0}, {1.5, 0, 0}}));
}

TEST(LocalMap, FindsTheNearestPointAsBruteForceDoes) {
  // Far from the origin, and one point per voxel's share, so that none is turned away.
  const Eigen::Vector3d center(52345.6, -81234.5, 12.0);
  Points kept;
  downsample(randomPoints(3000, {10, 10, 3}, center), 1.0, kept);
  LocalMap map(1.0, 20);
  map.add(kept, kUp);
  ASSERT_EQ(map.size(), kept.size());
  int found = 0;
  for (const Eigen::Vector3d& query : randomPoints(500, {12, 12, 4}, center)) {
    double best = 1e9;
    for (const Eigen::Vector3d& point : kept) best = std::min(best, (point - query).squaredNorm());
    const Neighbor nearest = map.nearest(query);
    if (best >= 1.0) continue;
    EXPECT_NEAR(nearest.squaredDistance, best, 1e-5);
    EXPECT_NEAR((nearest.point - query).squaredNorm(), best, 1e-5);
    ++found;
  }
  EXPECT_GT(found, 200);
}

TEST(LocalMap, KeepsPointsApartAndVoxelsSmall) {
  LocalMap map(1.0, 4);
  map.add({{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}}, kUp);
  EXPECT_EQ(map.size(), 1u);
  map.add(randomPoints(1000, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}), kUp);
  EXPECT_LE(map.size(), 4u);
}

TEST(LocalMap, ForgetsWhatIsFarAndUsesItsPlaceAgain) {
  LocalMap map(1.0, 20);
  map.add({{0.5, 0.5, 0.5}, {50.5, 0.5, 0.5}}, kUp);
  map.forgetBeyond({50, 0, 0}, 10.0);
  EXPECT_EQ(map.size(), 1u);
  EXPECT_TRUE(std::isinf(map.nearest({0.5, 0.5, 0.5}).squaredDistance));
  EXPECT_EQ(map.nearest({50.5, 0.5, 0.5}).squaredDistance, 0.0);
  map.add({{60.5, 0.5, 0.5}}, kUp);
  EXPECT_EQ(map.size(), 2u);
  EXPECT_EQ(map.nearest({60.5, 0.5, 0.5}).squaredDistance, 0.0);
}

TEST(LocalMap, TellsPlanesWithTheirNormals) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, 3).normalized();
  Points points = randomPoints(4000, {4, 4, 4});
  for (Eigen::Vector3d& point : points) point -= normal.dot(point) * normal;
  LocalMap map(1.0, 20);
  map.add(points, kUp);
  const Neighbor nearest = map.nearest({0, 0, 0});
  ASSERT_EQ(nearest.surface, Surface::Plane);
  EXPECT_NEAR(std::abs(nearest.normal.cast<double>().dot(normal)), 1.0, 1e-3);
}

TEST(LocalMap, TellsScatteredPointsFromPlanes) {
  LocalMap map(1.0, 20);
  map.add(randomPoints(4000, {3, 3, 3}), kUp);
  EXPECT_EQ(map.nearest({0, 0, 0}).surface, Surface::Scattered);
}

TEST(LocalMap, TrustsAPoleButNotTheLineThatABeamDraws) {
  Points pole, ring;
  for (double t = -3.0; t < 3.0; t += 0.25) {
    pole.emplace_back(0.5, 0.5, t);
    ring.emplace_back(t, 20.5, 0.5);
  }
  LocalMap map(1.0, 20);
  map.add(pole, kUp);
  map.add(ring, kUp);
  EXPECT_EQ(map.nearest({0.5, 0.5, 0}).surface, Surface::Scattered);
  EXPECT_EQ(map.nearest({0, 20.5, 0.5}).surface, Surface::Unknown);
}

}  // namespace
}  // namespace toss::test
