// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/segmentation/LevelFrame.h>

#include <cmath>
#include <limits>

namespace toss::test {
namespace {

TEST(LevelFrame, IsTheMapWithoutTheTranslation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() << 4e6, -3e6, 120.0;
  PointCloud points;
  points.resize(2);
  points.x = {1.0f, -30.0f}, points.y = {2.0f, 40.0f}, points.z = {3.0f, -1.5f};
  LevelPoints level;
  toLevelFrame(points, pose, level);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d expected =
        pose.linear() * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]).cast<double>();
    EXPECT_NEAR(level.x[i], expected.x(), 1e-5);
    EXPECT_NEAR(level.y[i], expected.y(), 1e-5);
    EXPECT_NEAR(level.z[i], expected.z(), 1e-5);
  }
}

TEST(LevelFrame, WhatIsNotFiniteIsNotANumber) {
  PointCloud points;
  points.resize(3);
  points.x[0] = std::numeric_limits<float>::infinity();
  points.y[1] = std::numeric_limits<float>::quiet_NaN();
  LevelPoints level;
  toLevelFrame(points, Eigen::Isometry3d::Identity(), level);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(std::isnan(level.x[i]) && std::isnan(level.y[i]) && std::isnan(level.z[i]));
  }
  EXPECT_EQ(level.z[2], 0.0f);
}

}  // namespace
}  // namespace toss::test
