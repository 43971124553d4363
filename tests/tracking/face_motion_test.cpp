// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/FaceMotion.h>

#include <cmath>

#include "TrackedScene.h"

namespace toss {
namespace {

/// A box whose rear and front face move along x at the given speeds [m/s], at 10 scans per second.
std::vector<TimedBox> movingFaces(double rearSpeed, double frontSpeed, int count) {
  std::vector<TimedBox> boxes;
  for (int i = 0; i < count; ++i) {
    const double time = 100.0 + 0.1 * i;
    const double rear = 1e5 + rearSpeed * 0.1 * i, front = 1e5 + 2.0 + frontSpeed * 0.1 * i;
    boxes.push_back({time, standingBox(0.5 * (rear + front), -1e5, front - rear, 1.0)});
  }
  return boxes;
}

TEST(FaceMotion, BothFacesOfARigidBoxMoveAlike) {
  const FaceMotion motion = fitFaceMotion(movingFaces(5.0, 5.0, 11));
  EXPECT_NEAR(motion.displacement, 5.0, 1e-6);
  EXPECT_NEAR(motion.leading, 5.0, 1e-6);
  EXPECT_NEAR(motion.lagging, 5.0, 1e-6);
  EXPECT_NEAR(motion.scatter, 0.0, 1e-4);
}

TEST(FaceMotion, GrowingViewMovesOneFaceAndAShrinkingOneTheOther) {
  const FaceMotion growing = fitFaceMotion(movingFaces(0.0, 3.0, 11));
  EXPECT_NEAR(growing.displacement, 1.5, 1e-6);
  EXPECT_NEAR(growing.leading, 3.0, 1e-6);
  EXPECT_NEAR(growing.lagging, 0.0, 1e-6);
  const FaceMotion shrinking = fitFaceMotion(movingFaces(1.5, 0.0, 11));
  EXPECT_NEAR(shrinking.leading, 1.5, 1e-6);
  EXPECT_NEAR(shrinking.lagging, 0.0, 1e-6);
}

TEST(FaceMotion, ScatterIsTheNoiseOfTheFaces) {
  std::mt19937 random(13);
  std::normal_distribution<double> noise(0.0, 0.2);
  std::vector<TimedBox> boxes = movingFaces(2.0, 2.0, 400);
  for (TimedBox& timed : boxes) timed.box.center.x() += noise(random);
  EXPECT_NEAR(fitFaceMotion(boxes).scatter, 0.2, 0.02);
}

TEST(FaceMotion, WorksForTurnedBoxesAlongAnyDirection) {
  std::vector<TimedBox> boxes;
  for (int i = 0; i < 10; ++i) {
    Box box = standingBox(0.3 * i, 0.4 * i, 4.0, 2.0);
    box.yaw = std::atan2(4.0, 3.0);
    boxes.push_back({0.1 * i, box});
  }
  const FaceMotion motion = fitFaceMotion(boxes);
  EXPECT_NEAR(motion.displacement, 4.5, 1e-9);
  EXPECT_NEAR(motion.lagging, 4.5, 1e-9);
  EXPECT_NEAR(reachAlong(boxes.front().box, {0.6, 0.8}), 2.0, 1e-12);
  EXPECT_NEAR(reachAlong(boxes.front().box, {-0.8, 0.6}), 1.0, 1e-12);
}

TEST(FaceMotion, TooFewOrStandingBoxesGiveZeros) {
  EXPECT_EQ(fitFaceMotion({}).displacement, 0.0);
  EXPECT_EQ(fitFaceMotion(movingFaces(5.0, 5.0, 2)).displacement, 0.0);
  EXPECT_EQ(fitFaceMotion(movingFaces(0.0, 0.0, 10)).displacement, 0.0);
}

}  // namespace
}  // namespace toss
