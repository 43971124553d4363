// SPDX-License-Identifier: BSD-3-Clause
#include "RenderFixtures.h"

namespace toss::test {
namespace {

constexpr int kWidth = 640, kHeight = 480;
const Color kRed{255, 0, 0}, kBlue{0, 0, 255}, kGreen{0, 255, 0}, kBlack{0, 0, 0};

Camera cameraOf(bool perspective, double azimuth, double elevation, double distance) {
  Camera camera;
  camera.perspective = perspective;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  camera.distance = distance;
  camera.width = kWidth;
  camera.height = kHeight;
  return camera;
}

PointBatch batchOf(const std::vector<Eigen::Vector3f>& positions, const Color& color, double size) {
  PointBatch batch;
  batch.positions = positions;
  batch.colors.assign(positions.size(), color);
  batch.size = size;
  return batch;
}

cv::Mat draw(const PointScene& scene, const Camera& camera, const RenderStyle& style) {
  cv::Mat picture;
  inRenderThread([&] {
    OffscreenRenderer renderer(kWidth, kHeight, 2);
    renderer.setScene(scene);
    picture = renderer.render(camera, style);
  });
  return picture;
}

TEST(OffscreenRendererTest, PutsPointsWhereTheCameraSaysInTheirColours) {
  // Far from the origin of the map, as UTM coordinates are.
  const Eigen::Vector3d origin(500000.0, 4500000.0, 300.0);
  const std::vector<Eigen::Vector3f> positions = {{0, 0, 0}, {6, -4, 2}, {-8, 5, -1}};
  const Color colors[] = {kRed, kGreen, kBlue};
  PointScene scene;
  scene.origin = origin;
  for (std::size_t i = 0; i < 3; ++i)
    scene.batches.push_back(batchOf({positions[i]}, colors[i], 0.4));
  for (Camera camera :
       {cameraOf(true, 0.6, 0.5, 50.0), cameraOf(false, -1.5707963, 1.5707963, 60.0),
        cameraOf(true, -2.4, 1.2, 80.0)}) {
    camera.target = origin + Eigen::Vector3d(1.0, -0.5, 0.3);
    cv::Mat picture;
    TOSS_DRAW_OR_SKIP(picture = draw(scene, camera, {kBlack, 0.0, 0.0}));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto expected = camera.project(origin + positions[i].cast<double>());
      ASSERT_TRUE(expected);
      const Blob blob =
          findBlob(picture, [&](const Color& c) { return isNear(c, colors[i], 100); });
      ASSERT_GT(blob.pixels, 0u);
      EXPECT_NEAR(blob.u, expected->u, 0.8);
      EXPECT_NEAR(blob.v, expected->v, 0.8);
      EXPECT_NEAR(blob.right - blob.left + 1, 0.4 * camera.pixelsPerMetre(expected->depth), 1.6);
      EXPECT_TRUE(isNear(colorAt(picture, expected->u, expected->v), colors[i], 2));
    }
  }
}

TEST(OffscreenRendererTest, WhatIsNearerHidesWhatIsFarther) {
  // Two walls 5 cm apart, seen from 100 m: 16-bit floats could not tell them apart.
  std::vector<Eigen::Vector3f> front, back;
  for (float y = -12.0f; y <= 12.0f; y += 0.1f)
    for (float z = -9.0f; z <= 9.0f; z += 0.1f) {
      front.push_back({0.05f, y, z});
      back.push_back({0.0f, y, z});
    }
  for (const bool backFirst : {false, true}) {
    PointScene scene;
    scene.batches = {batchOf(front, kRed, 0.15), batchOf(back, kBlue, 0.15)};
    if (backFirst) std::swap(scene.batches[0], scene.batches[1]);
    cv::Mat picture;
    TOSS_DRAW_OR_SKIP(picture = draw(scene, cameraOf(true, 0.0, 0.0, 100.0), {kBlack, 0.0, 0.0}));
    const cv::Mat middle = picture(cv::Rect(220, 160, 200, 160));
    const Blob seen = findBlob(middle, [&](const Color& c) { return isNear(c, kRed, 2); });
    EXPECT_EQ(seen.pixels, middle.total());
  }
}

TEST(OffscreenRendererTest, ShadingDarkensTheFarSideOfAnEdgeOnly) {
  std::vector<Eigen::Vector3f> low, high;
  for (float x = -20.0f; x <= 20.0f; x += 0.1f)
    for (float y = -20.0f; y <= 20.0f; y += 0.1f)
      (x < 0 ? low : high).push_back({x, y, x < 0 ? 0.0f : 4.0f});
  PointScene scene;
  scene.batches = {batchOf(low, kGreen, 0.2), batchOf(high, kGreen, 0.2)};
  const Camera camera = cameraOf(false, -1.5707963, 1.5707963, 60.0);
  cv::Mat plain, shaded;
  TOSS_DRAW_OR_SKIP(plain = draw(scene, camera, {kBlack, 0.0, 0.0}));
  shaded = draw(scene, camera, {kBlack, 0.0, 1.0});
  const double edge = camera.project({-0.1, 0.0, 0.0})->u;
  const auto darkestBesideEdge = [&](const cv::Mat& picture) {
    int darkest = 255;
    for (double u = edge - 4.0; u < edge + 1.0; u += 1.0)
      darkest = std::min<int>(darkest, colorAt(picture, u, 240).green);
    return darkest;
  };
  EXPECT_EQ(darkestBesideEdge(plain), 255);
  EXPECT_LT(darkestBesideEdge(shaded), 200);
  EXPECT_TRUE(isNear(colorAt(shaded, edge - 40, 240), kGreen, 4));
  EXPECT_TRUE(isNear(colorAt(shaded, edge + 40, 240), kGreen, 4));
}

TEST(OffscreenRendererTest, GivesTheSameBytesAgain) {
  std::mt19937 random(1);
  std::normal_distribution<float> value(0.0f, 8.0f);
  PointBatch batch;
  for (int i = 0; i < 20000; ++i) {
    batch.positions.push_back({value(random), value(random), value(random)});
    batch.colors.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 7), 99});
  }
  PointScene scene;
  scene.batches = {batch};
  const Camera camera = cameraOf(true, 0.3, 0.4, 60.0);
  cv::Mat a;
  TOSS_DRAW_OR_SKIP(a = draw(scene, camera, {kBlack, 0.0, 1.0}));
  const cv::Mat b = draw(scene, camera, {kBlack, 0.0, 1.0});
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
}

TEST(OffscreenRendererTest, DrawsNothingAsBackground) {
  cv::Mat picture;
  TOSS_DRAW_OR_SKIP(picture = draw({}, cameraOf(true, 0.0, 0.5, 10.0), {{10, 20, 30}, 0.0, 1.0}));
  EXPECT_EQ(findBlob(picture,
                     [](const Color& c) {
                       return !isNear(c, {10, 20, 30}, 0);
                     })
                .pixels,
            0u);
}

TEST(OffscreenRendererTest, RefusesWidthsThatMrptCanNotDraw) {
  EXPECT_THROW(inRenderThread([] { OffscreenRenderer(641, 480, 1); }), std::logic_error);
}

TEST(OffscreenRendererTest, ErrorsLeaveTheRenderThread) {
  EXPECT_THROW(inRenderThread([] { throw UserError("a"); }), UserError);
}

}  // namespace
}  // namespace toss::test
