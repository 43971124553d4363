// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <toss/render/SceneFile.h>

#include "RenderFixtures.h"

namespace toss::test {
namespace {

using mrpt::opengl::CPointCloudColoured;
using mrpt::opengl::CSetOfLines;
using mrpt::opengl::CSetOfObjects;

MapContent someRun() {
  MapContent content;
  content.staticPoints = rectangle(100, 120, 50, 60, 2, 0.5);
  content.movingPoints = rectangle(105, 106, 55, 56, 3, 0.5);
  content.trajectory = {{100, 55, 3}, {110, 55, 3}, {120, 56, 3}};
  Box box;
  box.center = {105, 55, 3};
  box.length = 4;
  box.width = box.height = 2;
  Box later = box;
  later.center.x() += 20.0;
  content.tracks = {{12, {box, later}}};
  return content;
}

std::shared_ptr<CSetOfObjects> readRun(const fs::path& file) {
  mrpt::opengl::COpenGLScene scene;
  EXPECT_TRUE(scene.loadFromFile(file.string()));
  return std::dynamic_pointer_cast<CSetOfObjects>(scene.getByName("toss_run"));
}

TEST(SceneFileTest, HoldsMapTrajectoryAndTracksByName) {
  const TemporaryFolder folder;
  const MapContent content = someRun();
  writeScene(content, folder / "scene.3Dscene", RenderOptions());
  const auto run = readRun(folder / "scene.3Dscene");
  ASSERT_TRUE(run);
  const auto map = std::dynamic_pointer_cast<CPointCloudColoured>(run->getByName("static_map"));
  ASSERT_TRUE(map);
  ASSERT_EQ(map->size(), content.staticPoints.size());
  const auto first = map->getPoint3Df(0);
  const auto origin = run->getPose();
  EXPECT_NEAR(first.x + origin.x, content.staticPoints[0].x, 1e-4);
  EXPECT_NEAR(first.y + origin.y, content.staticPoints[0].y, 1e-4);
  EXPECT_NEAR(first.z + origin.z, content.staticPoints[0].z, 1e-4);
  const auto removed =
      std::dynamic_pointer_cast<CPointCloudColoured>(run->getByName("removed_points"));
  ASSERT_TRUE(removed);
  EXPECT_EQ(removed->size(), content.movingPoints.size());
  EXPECT_GT(removed->getPointColor(0).R, 200);
  const auto linesIn = [&](const char* name) {
    const auto lines = std::dynamic_pointer_cast<CSetOfLines>(run->getByName(name));
    return lines ? lines->size() : 0;
  };
  EXPECT_EQ(linesIn("trajectory"), 2u);
  EXPECT_EQ(linesIn("track_12_path"), 1u);
  EXPECT_EQ(linesIn("track_12_boxes"), 24u);
}

TEST(SceneFileTest, ThinsLargeMapsAndTakesEmptyOnes) {
  const TemporaryFolder folder;
  MapContent content;
  content.staticPoints = rectangle(0, 50, 0, 50, 0, 0.5);
  RenderOptions options;
  options.sceneMaxPoints = 1000;
  writeScene(content, folder / "thin.3Dscene", options);
  const auto map = std::dynamic_pointer_cast<CPointCloudColoured>(
      readRun(folder / "thin.3Dscene")->getByName("static_map"));
  EXPECT_LE(map->size(), 1000u);
  EXPECT_GE(map->size(), 800u);
  writeScene(MapContent(), folder / "empty.3Dscene", options);
  EXPECT_TRUE(readRun(folder / "empty.3Dscene"));
  EXPECT_THROW(writeScene(content, folder / "no" / "folder.3Dscene", options), UserError);
}

}  // namespace
}  // namespace toss::test
