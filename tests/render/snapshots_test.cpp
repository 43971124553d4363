// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/Snapshots.h>

#include "RenderFixtures.h"

namespace toss::test {
namespace {

/// A plain of 100 m x 60 m with a mover that was removed, one left behind, and a lost wall.
ErrorContent plainWithErrors() {
  ErrorContent content;
  content.name = "plain";
  content.keptStatic = rectangle(0, 100, 0, 60, 0, 0.25);
  content.removedMoving = rectangle(20, 24, 40, 44, 1, 0.25);
  content.keptMoving = rectangle(50, 54, 30, 34, 1, 0.25);
  content.removedStatic = rectangle(80, 84, 10, 14, 1, 0.25);
  return content;
}

/// Where the plain lies in a top view, found from the picture alone.
Blob mapIn(const cv::Mat& picture) {
  const cv::Mat middle = picture.rowRange(picture.rows / 16, picture.rows * 15 / 16);
  const Color background = colorAt(middle, 2, middle.rows / 2);
  Blob blob = findBlob(middle, [&](const Color& c) { return !isNear(c, background, 6); });
  blob.top += picture.rows / 16;
  blob.bottom += picture.rows / 16;
  return blob;
}

RenderOptions smallPicture() {
  RenderOptions options;
  options.width = 960;
  options.height = 540;
  return options;
}

class SnapshotsTest : public ::testing::Test {
 protected:
  cv::Mat read(const std::string& name) const {
    return cv::imread((folder / name).string(), cv::IMREAD_COLOR);
  }
  TemporaryFolder folder;
};

TEST_F(SnapshotsTest, ErrorsAreAtTheirPlacesInTheirColours) {
  TOSS_DRAW_OR_SKIP(renderErrors(plainWithErrors(), View::Top, folder / "e.png", smallPicture()));
  const cv::Mat picture = read("e.png");
  ASSERT_EQ(picture.size(), cv::Size(960, 540));
  const Blob map = mapIn(picture);
  const double scale = (map.right - map.left + 1) / 100.0;
  EXPECT_NEAR((map.bottom - map.top + 1) / 60.0, scale, 0.02 * scale);
  const auto at = [&](double x, double y) {
    return colorAt(picture, map.left + x * scale, map.bottom - y * scale);
  };
  const Color removed = at(22, 42), residue = at(52, 32), lost = at(82, 12), kept = at(10, 10);
  EXPECT_GT(removed.green, removed.red + 60);
  EXPECT_GT(residue.red, residue.green + 120);
  EXPECT_GT(lost.blue, lost.red + 120);
  EXPECT_TRUE(isNear(kept, {kept.green, kept.green, kept.green}, 20));
}

TEST_F(SnapshotsTest, ScaleBarIsARoundNumberOfMetres) {
  for (const double size : {1.0, 3.7}) {
    MapContent content;
    content.staticPoints = rectangle(0, 100 * size, 0, 60 * size, 0, 0.25 * size);
    TOSS_DRAW_OR_SKIP(renderPicture(content, View::Top, folder / "m.png", smallPicture()));
    const cv::Mat picture = read("m.png");
    const Blob map = mapIn(picture);
    // The points have a size: it stands out over the map by half on each side.
    const double pixelsPerMetre = (map.right - map.left + 1) / ((100.0 + 0.25 * 1.4) * size);
    const cv::Mat strip = picture(cv::Rect(0, 512, 300, 28));
    const Blob bar = findBlob(strip.row(13), [](const Color& c) { return c.red > 225; });
    const double metres = (bar.right - bar.left + 1) / pixelsPerMetre;
    double nearest = 1e9;
    for (const double round : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
      if (std::abs(round - metres) < std::abs(nearest - metres)) nearest = round;
    EXPECT_NEAR(metres * pixelsPerMetre, nearest * pixelsPerMetre, 2.0) << metres;
    EXPECT_GT(bar.right - bar.left, 960 * 0.06);
  }
}

TEST_F(SnapshotsTest, TitleIsNeverCut) {
  MapContent content;
  content.staticPoints = rectangle(0, 10, 0, 10, 0, 0.5);
  for (const std::size_t length : {1u, 20u, 60u, 400u}) {
    content.name = std::string(length, 'W');
    TOSS_DRAW_OR_SKIP(renderPicture(content, View::Corner, folder / "t.png", smallPicture()));
    const cv::Mat strip = read("t.png").rowRange(0, 32);
    const Color panel = colorAt(strip, 1, 1);
    const Blob text = findBlob(strip, [&](const Color& c) { return !isNear(c, panel, 40); });
    EXPECT_GE(text.left, 8);
    EXPECT_LE(text.right, 960 - 8);
    EXPECT_GE(text.top, 3);
    EXPECT_LE(text.bottom, 29);
    // Title and subtitle stay apart.
    int gap = 0, longest = 0;
    for (int column = text.left; column <= text.right; ++column) {
      const Blob letter =
          findBlob(strip.col(column), [&](const Color& c) { return !isNear(c, panel, 40); });
      gap = letter.pixels == 0 ? gap + 1 : 0;
      longest = std::max(longest, gap);
    }
    EXPECT_GE(longest, 12);
  }
}

TEST_F(SnapshotsTest, WritesTheFourPicturesOfARunTheSameEachTime) {
  MapContent content;
  content.name = "run";
  content.staticPoints = rectangle(0, 60, 0, 30, 0, 0.2);
  content.movingPoints = rectangle(20, 24, 14, 16, 1, 0.1);
  content.trajectory = {{5, 5, 1}, {30, 6, 1}, {55, 5, 1}};
  Box box;
  box.center = {22, 15, 1};
  box.length = 4;
  box.width = box.height = 2;
  content.tracks = {{7, {box}}};
  TOSS_DRAW_OR_SKIP(renderSnapshots(content, folder / "a", smallPicture()));
  renderSnapshots(content, folder / "b", smallPicture());
  for (const char* name : kSnapshotNames) {
    const std::string bytes = readBytes(folder / "a" / name);
    EXPECT_GT(bytes.size(), 5000u);
    EXPECT_EQ(bytes, readBytes(folder / "b" / name)) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "a"), {}), 4);
  const auto isRed = [](const Color& c) { return c.red > 180 && c.green < 90 && c.blue < 90; };
  // Without the legend's swatch.
  const cv::Rect above(0, 0, 960, 500);
  EXPECT_GT(findBlob(read("a/removed_top.png")(above), isRed).pixels, 200u);
  EXPECT_GT(findBlob(read("a/removed_perspective.png")(above), isRed).pixels, 200u);
}

TEST_F(SnapshotsTest, ColoursTellHeightIntensityOrClass) {
  MapContent content;
  content.staticPoints = rectangle(0, 20, 0, 20, 0, 0.2);
  for (MapPoint& point : content.staticPoints) {
    point.z = point.x < 10 ? 0.0f : 2.0f;
    point.intensity = point.y < 10 ? 0.1f : 0.9f;
  }
  RenderOptions options = smallPicture();
  options.shading = 0.0;
  const auto corners = [&](PictureColor color) {
    options.color = color;
    renderPicture(content, View::Top, folder / "c.png", options);
    const cv::Mat picture = read("c.png");
    const Blob map = mapIn(picture);
    const int inset = (map.right - map.left) / 5;
    return std::array<Color, 3>{colorAt(picture, map.left + inset, map.bottom - inset),
                                colorAt(picture, map.right - inset, map.bottom - inset),
                                colorAt(picture, map.left + inset, map.top + inset)};
  };
  std::array<Color, 3> height;
  TOSS_DRAW_OR_SKIP(height = corners(PictureColor::Height));
  EXPECT_FALSE(isNear(height[0], height[1], 60));
  EXPECT_TRUE(isNear(height[0], height[2], 2));
  EXPECT_TRUE(isNear(height[0], rampColor(Ramp::Turbo, 0.0), 2));
  EXPECT_TRUE(isNear(height[1], rampColor(Ramp::Turbo, 1.0), 2));
  const auto intensity = corners(PictureColor::Intensity);
  EXPECT_TRUE(isNear(intensity[0], intensity[1], 2));
  EXPECT_FALSE(isNear(intensity[0], intensity[2], 60));
  const auto byClass = corners(PictureColor::Class);
  EXPECT_TRUE(isNear(byClass[0], byClass[2], 2));
  EXPECT_LT(std::abs(byClass[1].red - byClass[1].green), 20);
}

TEST_F(SnapshotsTest, OddAndEmptyContentIsDrawn) {
  RenderOptions options = smallPicture();
  options.width = 333;
  options.height = 251;
  options.background = Background::Light;
  MapContent content;
  for (const View view : {View::Top, View::Chase, View::Corner}) {
    content.staticPoints.clear();
    TOSS_DRAW_OR_SKIP(renderPicture(content, view, folder / "empty.png", options));
    EXPECT_EQ(read("empty.png").size(), cv::Size(332, 251));
    content.staticPoints = {{3, 4, 5, 6}};
    renderPicture(content, view, folder / "one.png", options);
    const Blob point = findBlob(read("one.png")(cv::Rect(40, 60, 252, 130)), [](const Color& c) {
      return !isNear(c, {250, 250, 250}, 10);
    });
    EXPECT_GT(point.pixels, 4u);
  }
  EXPECT_THROW(renderPicture(content, View::Top, folder / "no" / "folder.png", options), UserError);
  options.width = 3;
  EXPECT_THROW(renderPicture(content, View::Top, folder / "w.png", options), UserError);
}

}  // namespace
}  // namespace toss::test
