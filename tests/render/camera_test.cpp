// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/render/Camera.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

namespace toss {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;
const PictureFrame kFrame{20, 80, 1900, 1000};

ViewSubject subjectOf(const Extent& extent, double heading = 0.3) {
  ViewSubject subject;
  subject.extent = extent;
  subject.focus = extent.center();
  subject.heading = heading;
  return subject;
}

struct Seen {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
};

Seen seenCorners(const Camera& camera, const Extent& extent) {
  Seen seen;
  for (const Eigen::Vector3d& corner : extent.corners()) {
    const auto place = camera.project(corner);
    EXPECT_TRUE(place);
    if (!place) continue;
    seen.left = std::min(seen.left, place->u);
    seen.right = std::max(seen.right, place->u);
    seen.top = std::min(seen.top, place->v);
    seen.bottom = std::max(seen.bottom, place->v);
  }
  return seen;
}

TEST(CameraTest, TopViewIsAMapWithXRightAndYUp) {
  Camera camera;
  camera.perspective = false;
  camera.azimuth = -std::acos(-1.0) / 2.0;
  camera.elevation = std::acos(-1.0) / 2.0;
  camera.distance = 216.0;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.target = {100.0, 200.0, 5.0};
  // 108 m from top to bottom: 10 pixels per metre.
  EXPECT_DOUBLE_EQ(camera.pixelsPerMetre(1.0), 10.0);
  const auto place = camera.project({103.0, 207.0, -4.0});
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->u, 960.0 + 30.0, 1e-9);
  EXPECT_NEAR(place->v, 540.0 - 70.0, 1e-9);
  EXPECT_NEAR(place->depth, 225.0, 1e-9);
}

TEST(CameraTest, PerspectiveFollowsTheFieldOfView) {
  Camera camera;
  camera.distance = 50.0;
  camera.width = kWidth;
  camera.height = kHeight;
  // Along -x from (50, 0, 0): right is +y, and 15 degrees up is the upper edge.
  const double edge = 50.0 * std::tan(15.0 / 180.0 * std::acos(-1.0));
  const auto top = camera.project({0.0, 0.0, edge});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->v, 0.0, 1e-9);
  EXPECT_NEAR(top->u, 960.0, 1e-9);
  const auto right = camera.project({0.0, edge, 0.0});
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->u, 960.0 + 540.0, 1e-9);
  EXPECT_FALSE(camera.project({51.0, 0.0, 0.0}));
}

TEST(CameraTest, ShowsAllCornersOfAMapAndFillsTheFrame) {
  const Extent maps[] = {{{0, 0, 0}, {100, 60, 8}},
                         {{-5, -500, -3}, {5, 500, 40}},
                         {{1e6, -2e6, 100}, {1e6 + 3000, -2e6 + 20, 130}},
                         {{0, 0, 0}, {4, 4, 90}},
                         {{2, 2, 2}, {2, 2, 2}}};
  for (const Extent& map : maps)
    for (const View view : {View::Top, View::Corner}) {
      const Camera camera = frameView(view, subjectOf(map), kWidth, kHeight, kFrame);
      const Seen seen = seenCorners(camera, map);
      EXPECT_GE(seen.left, kFrame.left);
      EXPECT_LE(seen.right, kFrame.right);
      EXPECT_GE(seen.top, kFrame.top);
      EXPECT_LE(seen.bottom, kFrame.bottom);
      if (map.size().maxCoeff() < 1.0) continue;
      const double filled = std::max((seen.right - seen.left) / (kFrame.right - kFrame.left),
                                     (seen.bottom - seen.top) / (kFrame.bottom - kFrame.top));
      EXPECT_GT(filled, 0.97) << map.size().transpose();
      EXPECT_NEAR(0.5 * (seen.left + seen.right), 0.5 * (kFrame.left + kFrame.right), 2.0);
      EXPECT_NEAR(0.5 * (seen.top + seen.bottom), 0.5 * (kFrame.top + kFrame.bottom), 2.0);
    }
}

TEST(CameraTest, AnOutlineIsFramedMoreTightlyThanItsBox) {
  const Extent box{{0, 0, 0}, {100, 100, 10}};
  ViewSubject subject = subjectOf(box);
  // A street along the diagonal that runs across the view.
  for (int i = 0; i <= 100; ++i) subject.outline.push_back({double(i), double(100 - i), 0.0});
  const Camera tight = frameView(View::Corner, subject, kWidth, kHeight, kFrame);
  for (const Eigen::Vector3d& point : subject.outline) {
    const auto place = tight.project(point);
    ASSERT_TRUE(place);
    EXPECT_GE(place->u, kFrame.left);
    EXPECT_LE(place->u, kFrame.right);
  }
  EXPECT_LT(tight.distance,
            frameView(View::Corner, subjectOf(box), kWidth, kHeight, kFrame).distance);
}

TEST(CameraTest, ChaseStandsBehindAndAboveTheFocus) {
  const double heading = 0.7;
  const Extent map{{0, 0, 0}, {100, 80, 10}};
  const Camera camera = frameView(View::Chase, subjectOf(map, heading), kWidth, kHeight, kFrame);
  const Eigen::Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
  EXPECT_LT((camera.position() - map.center()).dot(ahead), -10.0);
  EXPECT_GT(camera.position().z(), map.high.z());
  const auto focus = camera.project(map.center());
  ASSERT_TRUE(focus);
  EXPECT_NEAR(focus->u, 960.0, 200.0);
  EXPECT_NEAR(focus->v, 540.0, 200.0);
  EXPECT_LT(camera.distance,
            frameView(View::Corner, subjectOf(map), kWidth, kHeight, kFrame).distance);
}

TEST(CameraTest, PictureAxesAreOrthonormalAndRightHanded) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-1.5, 1.5);
  for (int i = 0; i < 20; ++i) {
    Camera camera;
    camera.azimuth = 2.0 * angle(random);
    camera.elevation = angle(random);
    EXPECT_NEAR(camera.right().norm(), 1.0, 1e-12);
    EXPECT_TRUE(camera.right().cross(camera.up()).isApprox(-camera.forward(), 1e-12));
    EXPECT_GT(camera.up().z(), 0.0);
  }
}

}  // namespace
}  // namespace toss
