// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <toss/geometry/Box.h>
#include <toss/geometry/Error.h>

#include <algorithm>
#include <set>

#include "Random.h"
#include "World.h"

namespace toss::simulation {
namespace {

/// Something that takes up room: an instance and its box.
struct Body {
  int instance;
  Box box;
};

/// All bodies at a time; the carrier has instance -1.
std::vector<Body> bodiesAt(const World& world, double time) {
  std::vector<Body> bodies;
  for (const auto& object : world.stillObjects) bodies.push_back({object.instance, object.box});
  for (const Mover& mover : world.movers) {
    bodies.push_back({mover.instance, boxOf(mover.figure, world.poseOf(mover, time))});
  }
  Figure carrier;
  const bool legged = world.carrier.bounce > 0.0;
  carrier.size = legged ? Eigen::Vector3d(0.7, 0.4, 0.5) : Eigen::Vector3d(4.4, 1.8, 1.6);
  bodies.push_back({-1, boxOf(carrier, world.mapFromSensor(time))});
  return bodies;
}

class Scenes : public testing::TestWithParam<std::string> {};

TEST_P(Scenes, NothingGoesThroughAnythingElse) {
  // Arms that swing, a door at its car, people shoulder to shoulder.
  constexpr double kTolerated = 0.2;
  const Scene& scene = findScene(GetParam());
  World world;
  RandomStream random(hash(1, 1));
  scene.build(world, random);
  std::set<std::pair<int, int>> collisions;
  for (double time = 0.0; time < 0.1 * scene.info.frames; time += 0.4) {
    const std::vector<Body> bodies = bodiesAt(world, time);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Box &a = bodies[i].box, &b = bodies[j].box;
        const double reach = 0.5 * (a.length + a.width + b.length + b.width);
        if ((a.center - b.center).norm() > reach) continue;
        if (footprintIntersection(a, b) < kTolerated) continue;
        if (collisions.insert({bodies[j].instance, bodies[i].instance}).second) {
          ADD_FAILURE() << bodies[j].instance << " meets " << bodies[i].instance << " at " << time
                        << " s near " << a.center.transpose();
        }
      }
    }
  }
}

TEST_P(Scenes, SomethingMovesAndLabelsAreMovingClasses) {
  const Scene& scene = findScene(GetParam());
  World world;
  RandomStream random(hash(1, 1));
  scene.build(world, random);
  int moving = 0;
  for (const Mover& mover : world.movers) {
    EXPECT_GE(mover.figure.movingLabel, 252);
    EXPECT_LE(mover.figure.movingLabel, 259);
    EXPECT_LT(mover.figure.stillLabel, 252);
    moving += world.movesWithin(mover, 0.0, 0.1, scene.info.frames) ? 1 : 0;
  }
  EXPECT_EQ(moving, static_cast<int>(world.movers.size()));
  EXPECT_GT(moving, 1);
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneInfo& info : knownScenes()) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Every, Scenes, testing::ValuesIn(sceneNames()), [](const auto& scene) {
  std::string name = scene.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace toss::simulation
