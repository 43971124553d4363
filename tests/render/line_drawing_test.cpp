// SPDX-License-Identifier: BSD-3-Clause
#include "LineDrawing.h"
#include "RenderFixtures.h"

namespace toss::test {
namespace {

Box boxAt(double x) {
  Box box;
  box.center = {x, 2.0, 1.0};
  box.length = 4.0;
  box.width = 2.0;
  box.height = 1.5;
  box.yaw = 0.5;
  return box;
}

TEST(LineDrawingTest, EdgesAreTheTwelveOfTheBox) {
  const Box box = boxAt(7.0);
  std::vector<double> lengths;
  for (const auto& [from, to] : edgesOf(box)) {
    lengths.push_back((to - from).norm());
    const Eigen::Vector3d middle = 0.5 * (from + to);
    EXPECT_TRUE(contains(box, middle, 1e-9));
    EXPECT_FALSE(contains(box, middle, -1e-6));
  }
  std::sort(lengths.begin(), lengths.end());
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(lengths[i], i < 4 ? 1.5 : i < 8 ? 2.0 : 4.0, 1e-12);
}

TEST(LineDrawingTest, FirstAndLastBoxAreAlwaysShown) {
  TrackPath path;
  EXPECT_TRUE(shownBoxes(path).empty());
  for (int i = 0; i <= 50; ++i) path.boxes.push_back(boxAt(i));
  const auto shown = shownBoxes(path);
  ASSERT_EQ(shown.size(), 6u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(shown[i].center.x(), 12.0 * static_cast<double>(i));
  EXPECT_EQ(shown[5].center.x(), 50.0);
}

TEST(LineDrawingTest, LinesGoWhereTheCameraSeesTheirEnds) {
  Camera camera;
  camera.distance = 60.0;
  camera.elevation = 0.4;
  camera.width = 640;
  camera.height = 480;
  cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(0));
  const Eigen::Vector3d from(0, -5, 0), to(3, 6, 2), behind(200, 0, 0);
  drawPolyline(picture, camera, {from, to}, {255, 255, 255}, 2.0);
  const auto a = camera.project(from), b = camera.project(to);
  ASSERT_TRUE(a && b);
  const Blob line = findBlob(picture, [](const Color& c) { return c.red > 60; });
  EXPECT_NEAR(line.left, std::min(a->u, b->u), 2.0);
  EXPECT_NEAR(line.right, std::max(a->u, b->u), 2.0);
  EXPECT_NEAR(line.top, std::min(a->v, b->v), 2.0);
  EXPECT_NEAR(line.bottom, std::max(a->v, b->v), 2.0);
  // An end behind the camera has no place in the picture: nothing is drawn.
  cv::Mat empty(480, 640, CV_8UC3, cv::Scalar::all(0));
  drawPolyline(empty, camera, {from, behind}, {255, 255, 255}, 2.0);
  EXPECT_EQ(cv::norm(empty, cv::NORM_INF), 0.0);
}

TEST(LineDrawingTest, OnlyTracesThatGoSomewhereAreDrawn) {
  Camera camera;
  camera.distance = 60.0;
  camera.width = 640;
  camera.height = 480;
  const auto pixelsOf = [&](int boxes, double step) {
    TrackPath path;
    path.track = 1;
    for (int i = 0; i < boxes; ++i) path.boxes.push_back(boxAt(step * i));
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(0));
    drawTrack(picture, camera, path);
    return findBlob(picture, [](const Color& c) { return c.green > 60; }).pixels;
  };
  EXPECT_GT(pixelsOf(10, 0.5), 50u);
  EXPECT_EQ(pixelsOf(4, 2.0), 0u);
  EXPECT_EQ(pixelsOf(10, 0.1), 0u);
}

}  // namespace
}  // namespace toss::test
