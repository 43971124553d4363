// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "ViewerState.h"

namespace toss::test {
namespace {

ViewerState pressed(const std::string& keys) {
  ViewerState state;
  for (const char key : keys) state.press(key);
  return state;
}

TEST(ViewerKeys, PauseAndStep) {
  EXPECT_TRUE(pressed(" ").paused);
  EXPECT_FALSE(pressed("  ").paused);
  EXPECT_TRUE(pressed("n").step);
  EXPECT_TRUE(pressed("n").paused);
}

TEST(ViewerKeys, SpeedStaysWithinItsBounds) {
  EXPECT_EQ(pressed("+").speed, 2.0);
  EXPECT_EQ(pressed("-").speed, 0.5);
  EXPECT_EQ(pressed("-------").speed, 0.125);
  EXPECT_EQ(pressed("++++").speed, 16.0);
  EXPECT_EQ(pressed("+++++").speed, 0.0);
  EXPECT_EQ(pressed("++++++").speed, 0.0);
  EXPECT_EQ(pressed("+++++-").speed, 16.0);
}

TEST(ViewerKeys, CameraModesGoAround) {
  EXPECT_EQ(pressed("c").camera, CameraMode::Top);
  EXPECT_EQ(pressed("cc").camera, CameraMode::Follow);
  EXPECT_EQ(pressed("ccc").camera, CameraMode::Free);
  EXPECT_EQ(pressed("cccc").camera, CameraMode::Chase);
}

TEST(ViewerKeys, LayersAreToggledByNumber) {
  const LayerChoice layers = pressed("1355").layers;
  EXPECT_FALSE(layers.has(Layer::Ground));
  EXPECT_TRUE(layers.has(Layer::Standing));
  EXPECT_FALSE(layers.has(Layer::Moving));
  EXPECT_TRUE(layers.has(Layer::Map));
  EXPECT_FALSE(pressed("6").layers.has(Layer::Trajectory));
}

TEST(ViewerKeys, PointsStayVisible) {
  EXPECT_EQ(pressed("]").layers.pointSize, 4.0);
  EXPECT_EQ(pressed("[[[[[[").layers.pointSize, 1.0);
}

TEST(ViewerKeys, QuitHelpAndScreenshot) {
  EXPECT_TRUE(pressed("q").quit);
  EXPECT_TRUE(pressed("\x1b").quit);
  EXPECT_TRUE(pressed("h").help);
  EXPECT_FALSE(pressed("hh").help);
  EXPECT_TRUE(pressed("S").screenshot);
  EXPECT_FALSE(pressed("z7 z ").paused);
}

}  // namespace
}  // namespace toss::test
