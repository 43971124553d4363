// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Box.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace toss {
namespace {

Box makeBox(double x, double y, double yaw, double length, double width, double height = 1.0) {
  Box box;
  box.center = {x, y, 0.0};
  box.yaw = yaw;
  box.length = length, box.width = width, box.height = height;
  return box;
}

TEST(IntersectionOverUnion, IdenticalBoxesAtAnyYawGiveOne) {
  for (const double yaw : {0.0, 0.3, -1.2, M_PI / 4, 1.5}) {
    const Box box = makeBox(3.0, -2.0, yaw, 4.2, 1.8, 1.5);
    EXPECT_NEAR(intersectionOverUnion(box, box), 1.0, 1e-12) << yaw;
  }
}

TEST(IntersectionOverUnion, SquareTurnedByARightAngleIsItself) {
  EXPECT_NEAR(intersectionOverUnion(makeBox(0, 0, 0, 2, 2), makeBox(0, 0, M_PI / 2, 2, 2)), 1.0,
              1e-12);
}

TEST(IntersectionOverUnion, UnitSquaresAt45DegreesShareAnOctagon) {
  const Box straight = makeBox(0, 0, 0, 1, 1), turned = makeBox(0, 0, M_PI / 4, 1, 1);
  EXPECT_NEAR(footprintIntersection(straight, turned), 2.0 * (std::sqrt(2.0) - 1.0), 1e-12);
  EXPECT_NEAR(intersectionOverUnion(straight, turned), 1.0 / std::sqrt(2.0), 1e-12);
}

TEST(IntersectionOverUnion, ContainedBoxGivesTheRatioOfVolumes) {
  const Box inner = makeBox(0.2, 0.1, 0.7, 1.0, 0.5, 0.5), outer = makeBox(0, 0, -0.4, 4, 4, 2);
  EXPECT_NEAR(intersectionOverUnion(inner, outer), inner.volume() / outer.volume(), 1e-12);
}

TEST(IntersectionOverUnion, TouchingBoxesShareNothing) {
  EXPECT_EQ(intersectionOverUnion(makeBox(0, 0, 0, 2, 1), makeBox(2, 0, 0, 2, 1)), 0.0);
  EXPECT_NEAR(intersectionOverUnion(makeBox(0, 0, 0.5, 2, 1),
                                    makeBox(2 * std::cos(0.5), 2 * std::sin(0.5), 0.5, 2, 1)),
              0.0, 1e-12);
  Box above = makeBox(0, 0, 0, 2, 1);
  above.center.z() = 1.0;
  EXPECT_EQ(intersectionOverUnion(makeBox(0, 0, 0, 2, 1), above), 0.0);
}

TEST(IntersectionOverUnion, FlatBoxesGiveZeroAndNeverNan) {
  const Box flat = makeBox(0, 0, 0.3, 2, 0), point = makeBox(0, 0, 0, 0, 0, 0);
  EXPECT_EQ(intersectionOverUnion(flat, flat), 0.0);
  EXPECT_EQ(intersectionOverUnion(point, point), 0.0);
  EXPECT_EQ(intersectionOverUnion(flat, makeBox(0, 0, 0, 1, 1)), 0.0);
}

TEST(IntersectionOverUnion, StaysExactFarFromTheOrigin) {
  const Box near1 = makeBox(0, 0, 0.3, 4, 2), near2 = makeBox(1, 0.5, -0.4, 3, 2);
  Box far1 = near1, far2 = near2;
  far1.center += Eigen::Vector3d(5e6, -4e6, 0), far2.center += Eigen::Vector3d(5e6, -4e6, 0);
  EXPECT_NEAR(intersectionOverUnion(far1, far2), intersectionOverUnion(near1, near2), 1e-8);
}

/// Share of random points of `a` that also lie in `b`, times the footprint of `a`.
double sampledIntersection(const Box& a, const Box& b, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  constexpr int kSamples = 20000;
  int inside = 0;
  for (int i = 0; i < kSamples; ++i) {
    const Eigen::Vector2d own(unit(random) * a.length, unit(random) * a.width);
    Eigen::Vector3d point = a.center;
    point.head<2>() += Eigen::Rotation2Dd(a.yaw) * own;
    inside += contains(b, point) ? 1 : 0;
  }
  return a.length * a.width * inside / kSamples;
}

TEST(FootprintIntersection, AgreesWithRandomSampling) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-2.0, 2.0), turn(-M_PI / 2, M_PI / 2),
      side(0.2, 5.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Box a = makeBox(place(random), place(random), turn(random), side(random), side(random));
    const Box b = makeBox(place(random), place(random), turn(random), side(random), side(random));
    const double exact = footprintIntersection(a, b);
    const double fourSigma = 4.0 * a.length * a.width * 0.5 / std::sqrt(20000.0);
    EXPECT_NEAR(exact, sampledIntersection(a, b, random), fourSigma + 1e-9) << "trial " << trial;
    EXPECT_NEAR(exact, footprintIntersection(b, a), 1e-9);
  }
}

TEST(FootprintIntersection, AxisAlignedPathEqualsTheGeneralOne) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-2.0, 2.0), side(0.0, 4.0);
  for (int trial = 0; trial < 500; ++trial) {
    const Box a = makeBox(place(random), place(random), 0.0, side(random), side(random));
    Box b = makeBox(place(random), place(random), 0.0, side(random), side(random));
    const double fast = footprintIntersection(a, b);
    b.yaw = M_PI;
    EXPECT_NEAR(footprintIntersection(a, b), fast, 1e-9);
  }
}

TEST(Contains, CountsTheBorderAndTheMargin) {
  const Box box = makeBox(1, 2, M_PI / 2, 4, 2);
  EXPECT_TRUE(contains(box, {1.0, 3.9, 0.0}));
  EXPECT_FALSE(contains(box, {2.9, 2.0, 0.0}));
  EXPECT_FALSE(contains(box, {1.0, 4.2, 0.0}));
  EXPECT_TRUE(contains(box, {1.0, 4.2, 0.0}, 0.25));
  EXPECT_FALSE(contains(box, {1.0, 2.0, 0.8}, 0.25));
  EXPECT_FALSE(contains(box, {std::nan(""), 2.0, 0.0}));
}

}  // namespace
}  // namespace toss
