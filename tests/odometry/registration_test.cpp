// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <toss/odometry/AdaptiveThreshold.h>
#include <toss/odometry/Registration.h>

#include <cmath>
#include <random>

namespace toss::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Isometry3d motion(double x, double y, double z, double angle) {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.2, -0.1, 1).normalized()));
  pose.pretranslate(Eigen::Vector3d(x, y, z));
  return pose;
}

/// Two walls along x and a floor, every 0.1 m; with `end` also a wall that closes them.
Points corridor(bool end) {
  Points points;
  for (double x = -10.0; x <= 10.0; x += 0.25)
    for (double t = 0.0; t <= 4.0; t += 0.25) {
      points.emplace_back(x, -2.0, t);
      points.emplace_back(x, 2.0, t);
      points.emplace_back(x, t - 2.0, 0.0);
      if (end) points.emplace_back(6.0, t - 2.0, 0.4 * (x + 10.0) / 2.0);
    }
  return points;
}

LocalMap mapOf(const Points& points) {
  LocalMap map(1.0, 20);
  map.add(points, Eigen::Vector3d::UnitZ());
  return map;
}

Points seenFrom(const Eigen::Isometry3d& mapFromSensor, const Points& points) {
  Points seen;
  for (std::size_t i = 0; i < points.size(); i += 3)
    seen.push_back(mapFromSensor.inverse() * points[i]);
  return seen;
}

TEST(Registration, FindsTheWayBack) {
  const Points points = corridor(true);
  const LocalMap map = mapOf(points);
  for (const Eigen::Isometry3d& truth :
       {motion(0.4, -0.2, 0.1, 0.03), motion(-0.3, 0.3, -0.1, -0.05), motion(0, 0, 0, 0)}) {
    const Alignment found =
        align(seenFrom(truth, points), map, Eigen::Isometry3d::Identity(), {3.0, 0.3, 200, 1e-6});
    const Eigen::Isometry3d error = found.mapFromSensor.inverse() * truth;
    EXPECT_TRUE(found.converged);
    EXPECT_LT(error.translation().norm(), 0.01);
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.002);
    EXPECT_GT(found.overlap, 0.99);
  }
}

TEST(Registration, TellsWhereTheGeometryLetsItSlide) {
  const Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
  const Points closed = corridor(true), open = corridor(false);
  EXPECT_GT(align(seenFrom(start, closed), mapOf(closed), start, {}).weakestHold, 0.05);
  EXPECT_LT(align(seenFrom(start, open), mapOf(open), start, {}).weakestHold, 0.03);
}

TEST(Registration, KeepsTheGuessWhereNothingOverlaps) {
  const Points points = corridor(true);
  const Eigen::Isometry3d far = motion(500, 0, 0, 0);
  const Alignment found = align(points, mapOf(points), far, {});
  EXPECT_TRUE(found.mapFromSensor.matrix() == far.matrix());
  EXPECT_EQ(found.overlap, 0.0);
  EXPECT_FALSE(found.converged);
  EXPECT_FALSE(align({}, mapOf(points), far, {}).converged);
}

TEST(Registration, DoesNotDependOnTheNumberOfThreads) {
  const Points points = corridor(true);
  const LocalMap map = mapOf(points);
  const Points seen = seenFrom(motion(0.3, 0.1, 0, 0.02), points);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return align(seen, map, Eigen::Isometry3d::Identity(), {}).mapFromSensor.matrix();
  };
  EXPECT_TRUE(run(1) == run(4));
}

TEST(AdaptiveThreshold, IsTheRootMeanSquareOfDeviationsThatCount) {
  AdaptiveThreshold threshold(2.0, 0.1, 50.0);
  EXPECT_EQ(threshold.sigma(), 2.0);
  threshold.add(motion(0.05, 0, 0, 0));
  EXPECT_EQ(threshold.sigma(), 2.0);
  threshold.add(motion(0.3, 0, 0.4, 0));
  EXPECT_NEAR(threshold.sigma(), 0.5, 1e-12);
  // The way of a point at 50 m that turns by 0.02 rad: its chord.
  threshold.add(motion(0, 0, 0, 0.02));
  const double chord = 100.0 * std::sin(0.01);
  EXPECT_NEAR(threshold.sigma(), std::sqrt((0.25 + chord * chord) / 2.0), 1e-9);
}

}  // namespace
}  // namespace toss::test
