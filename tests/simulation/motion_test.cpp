// SPDX-License-Identifier: BSD-3-Clause
#include "Motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toss::simulation {
namespace {

TEST(SpeedProfile, DistanceIsTheIntegralOfTheSpeed) {
  const SpeedProfile profile({{-1.0, 2.0}, {1.0, 8.0}, {3.0, 0.0}, {5.0, 0.0}, {6.0, -1.0}});
  double numeric = 0.0;
  constexpr double kStep = 1e-4;
  for (int i = 0; i < 80000; ++i) {
    if (i % 10000 == 0) {
      EXPECT_NEAR(profile.distance(i * kStep), numeric, 1e-3) << i * kStep;
    }
    numeric += kStep * profile.speed((i + 0.5) * kStep);
  }
  EXPECT_NEAR(profile.distance(-3.0), -(5.0 + 2.0) / 2.0 - 2.0 * 2.0, 1e-12);
}

TEST(Path, IsParametrisedByArcLengthAndGoesOnStraight) {
  const Path path({{0.0, 0.0}, {20.0, 0.0}, {20.0, 30.0}}, 5.0);
  for (double s = -5.0; s < path.length() + 5.0; s += 0.5) {
    const double step = (path.position(s + 0.01) - path.position(s)).norm();
    EXPECT_NEAR(step, 0.01, 1e-3) << s;
  }
  EXPECT_NEAR(path.heading(2.0), 0.0, 1e-12);
  EXPECT_NEAR(path.heading(path.length() + 3.0), 0.5 * M_PI, 1e-12);
  EXPECT_NEAR((path.position(-4.0) - Eigen::Vector2d(-4.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Path, ShiftedKeepsItsDistance) {
  const Path path({{0.0, 0.0}, {20.0, 0.0}, {20.0, 30.0}}, 5.0);
  const Path left = path.shifted(2.0);
  EXPECT_NEAR(left.position(1.0).y(), 2.0, 1e-3);
  EXPECT_NEAR(left.position(left.length()).x(), 18.0, 1e-3);
}

}  // namespace
}  // namespace toss::simulation
