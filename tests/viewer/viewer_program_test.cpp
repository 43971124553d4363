// SPDX-License-Identifier: BSD-3-Clause
// The viewer as a user runs it: a film without a display, and a window under Xvfb.
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "CrossingLog.h"
#include "LiveColors.h"
#include "ScreenPicture.h"

namespace toss::test {
namespace {

class ViewerProgram : public CrossingLog {
 protected:
  static int runViewer(const std::string& arguments, const std::string& before = "") {
    const std::string command = before + " " + quoted(TOSS_VIEWER_PROGRAM) + " " + arguments +
                                " >" + quoted(in("out")) + " 2>" + quoted(in("error"));
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  static bool canDraw() {
    return runProgram("snapshot " + quoted((run() / "static_map.ply").string()) + " --out " +
                      quoted(in("try.png")))
               .code == 0;
  }
};

/// Pixels whose colour is that of a layer, as far as shading and compression leave it.
std::size_t pixelsLike(const cv::Mat& picture, const Color& color) {
  const cv::Vec3d wanted(color.blue, color.green, color.red);
  std::size_t count = 0;
  for (int row = 0; row < picture.rows; ++row)
    for (int column = 0; column < picture.cols; ++column) {
      const cv::Vec3d pixel = picture.at<cv::Vec3b>(row, column);
      const double brightness = cv::norm(pixel);
      if (brightness < 60.0) continue;
      count += pixel.dot(wanted) / brightness / cv::norm(wanted) > 0.985;
    }
  return count;
}

void expectLayers(const cv::Mat& picture) {
  EXPECT_GT(pixelsLike(picture, kGroundColor), 500u);
  EXPECT_GT(pixelsLike(picture, kStandingColor), 2000u);
  EXPECT_GT(pixelsLike(picture, kMovingColor), 200u);
}

TEST_F(ViewerProgram, RecordsAFilmWithoutADisplay) {
  if (!canDraw()) GTEST_SKIP() << "this machine can not draw off-screen";
  const fs::path film = in("film.mp4");
  ASSERT_EQ(runViewer(quoted(rawlog()) + " --record " + quoted(film) + " --size 640x360 -q",
                      "env -u DISPLAY"),
            0)
      << readBytes(in("error"));
  cv::VideoCapture reader(film.string());
  cv::Mat frame, last;
  std::uint64_t frames = 0;
  for (; reader.read(frame); ++frames) last = frame.clone();
  EXPECT_EQ(frames, kScans);
  ASSERT_EQ(last.cols, 640);
  ASSERT_EQ(last.rows, 360);
  EXPECT_GT(pixelsLike(last, kStandingColor), 500u);
  EXPECT_GT(pixelsLike(last, kMovingColor), 50u);
}

TEST_F(ViewerProgram, ShowsTheLayersInItsWindow) {
  if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
  const VirtualDisplay display(in("display"));
  const std::string command = quoted(TOSS_VIEWER_PROGRAM) + " " + quoted(rawlog());
  BackgroundProgram viewer(display.environment() + command);
  // The window is there when the movers are: they take a few scans to be known.
  cv::Mat picture;
  for (int attempt = 0; attempt < 600 && viewer.isRunning(); ++attempt) {
    picture = display.picture();
    if (pixelsLike(picture, kMovingColor) > 200) break;
  }
  EXPECT_TRUE(viewer.isRunning());
  expectLayers(picture);
}

TEST_F(ViewerProgram, WritesWhatTheWindowShowsAndCloses) {
  if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
  const VirtualDisplay display(in("display"));
  const fs::path file = in("shot.png");
  ASSERT_EQ(runViewer(quoted(rawlog()) + " --screenshot " + quoted(file), display.environment()), 0)
      << readBytes(in("error"));
  const cv::Mat picture = cv::imread(file.string());
  ASSERT_EQ(picture.cols, 1280);
  expectLayers(picture);
}

TEST_F(ViewerProgram, SaysInOneLineWhatIsWrong) {
  EXPECT_EQ(runViewer(quoted(rawlog()), "env -u DISPLAY"), 1);
  EXPECT_THAT(readBytes(in("error")), ::testing::HasSubstr("--record"));
  EXPECT_EQ(runViewer("nowhere.rawlog"), 1);
  EXPECT_EQ(runViewer(quoted(rawlog()) + " --size 12"), 1);
  EXPECT_EQ(runViewer(quoted(rawlog()) + " --record /nowhere/film.mp4 -q"), 1);
  const std::string complaint = readBytes(in("error"));
  EXPECT_EQ(std::count(complaint.begin(), complaint.end(), '\n'), 1) << complaint;
  EXPECT_EQ(runViewer("--help"), 0);
}

}  // namespace
}  // namespace toss::test
