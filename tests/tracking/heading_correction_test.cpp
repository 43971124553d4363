// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/HeadingCorrection.h>

#include <cmath>
#include <random>

namespace toss {
namespace {

TEST(WrapYaw, LandsInTheHalfOpenHalfTurn) {
  for (double yaw = -20.0; yaw < 20.0; yaw += 0.01) {
    const double wrapped = wrapYaw(yaw);
    EXPECT_GE(wrapped, -M_PI / 2);
    EXPECT_LT(wrapped, M_PI / 2);
    EXPECT_NEAR(std::remainder(wrapped - yaw, M_PI), 0.0, 1e-9);
  }
  EXPECT_DOUBLE_EQ(wrapYaw(M_PI / 2), -M_PI / 2);
}

TEST(AlignedWithYaw, DescribesTheSameBoxNearTheGivenYaw) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(-7.0, 7.0), side(0.5, 5.0);
  for (int trial = 0; trial < 1000; ++trial) {
    Box box;
    box.yaw = turn(random), box.length = side(random), box.width = side(random), box.height = 1.0;
    const double yaw = turn(random);
    const Box aligned = alignedWithYaw(box, yaw);
    EXPECT_LE(std::abs(aligned.yaw - yaw), M_PI / 4 + 1e-9);
    EXPECT_NEAR(intersectionOverUnion(box, aligned), 1.0, 1e-9);
  }
}

TEST(AlignedWithYaw, LeavesAxisAlignedBoxesAlone) {
  Box box;
  box.length = 1.0, box.width = 3.0;
  const Box aligned = alignedWithYaw(box, 0.0);
  EXPECT_EQ(aligned.yaw, 0.0);
  EXPECT_EQ(aligned.length, 1.0);
  EXPECT_EQ(aligned.width, 3.0);
}

}  // namespace
}  // namespace toss
