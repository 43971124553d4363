// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "../objects/People.h"
#include "../objects/Structures.h"
#include "../objects/Vegetation.h"
#include "Rows.h"
#include "SceneBuilders.h"
#include "Trail.h"

namespace toss::simulation {
namespace {

/// Two ridges: slopes of 20 to 27 degrees along the way, as steep across it beside the way.
double hillHeight(double x, double y) {
  const double ridge = 3.2 * (1.0 - std::cos(x / 6.6));
  const double flank = 2.5 * std::sin(y / 8.0 + 0.4 * std::sin(x / 17.0)) - 2.5 * std::sin(0.0);
  return ridge + flank + 0.05 * std::sin(x / 1.3) * std::sin(y / 1.7);
}

const std::vector<Eigen::Vector2d> kWay = {
    {-25.0, 0.0}, {0.0, 0.5}, {14.0, 3.0}, {26.0, -1.0}, {60.0, 1.0}};

double distanceToWay(const Path& way, double x, double y) {
  double nearest = 1e9;
  for (double s = 0.0; s < way.length(); s += 1.0) {
    nearest = std::min(nearest, (way.position(s) - Eigen::Vector2d(x, y)).norm());
  }
  return nearest;
}

void addHill(World& world, const Path& way) {
  world.groundHeight = hillHeight;
  world.add(gridMesh(
      gridLines(-40.0, 75.0, 0.6), gridLines(-45.0, 45.0, 0.6),
      [](double x, double y) { return Eigen::Vector3d(x, y, hillHeight(x, y)); },
      [&](double x, double y) {
        return distanceToWay(way, x, y) < 1.6 ? Surface{semantics::kOtherGround, Material::Soil}
                                              : Surface{semantics::kTerrain, Material::Grass};
      }));
}

void addPlants(World& world, RandomStream& random, const Path& way) {
  for (int plant = 0; plant < 170; ++plant) {
    const double x = random.uniform(-35.0, 70.0), y = random.uniform(-35.0, 35.0);
    const double far = distanceToWay(way, x, y);
    if (far < 3.0) continue;
    const int kind = random.index(10);
    if (kind < 2 && far > 5.0) {
      world.place(makeConifer(random, random.uniform(3.0, 8.0)), x, y);
    } else if (kind < 4 && far > 5.0) {
      world.place(makeTree(random, random.uniform(4.0, 8.0), 900), x, y);
    } else if (kind < 7) {
      world.place(makeAnyBush(random, 1.2, 1.5), x, y);
    } else {
      world.place(makeTallGrass(random, random.uniform(0.6, 1.8), 25), x, y);
    }
  }
  // A fence that follows the slope beside the way, panel by panel.
  for (double s = 20.0; s < 70.0; s += 2.0) {
    const Eigen::Vector2d p = way.shifted(2.4).position(s);
    const double yaw = way.heading(s + 1.0);
    const Eigen::Vector2d q = p + 2.0 * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
    Eigen::Isometry3d pose = planarPose(p.x(), p.y(), hillHeight(p.x(), p.y()), yaw);
    const double rise = hillHeight(q.x(), q.y()) - hillHeight(p.x(), p.y());
    pose.rotate(Eigen::AngleAxisd(-std::atan2(rise, 2.0), Eigen::Vector3d::UnitY()));
    world.add(makeFence(2.0, 1.1), pose);
  }
  world.place(makeBench(), 21.0, -4.5);
}

void addPeople(World& world, RandomStream& random, const Path& way) {
  const Path back({kWay.rbegin(), kWay.rend()}, 6.0);
  const double total = way.length();
  addWalkersInLine(world, random, way, -0.9, 28.0, 4, 0.6, 1.1);
  addWalkersInLine(world, random, way, 0.75, 30.0, 3, 0.7, 1.2);
  addWalkersInLine(world, random, back, -1.45, total - 60.0, 6, 0.4, 1.1);
  addGroup(world, random, {back.shifted(2.5), SpeedProfile::constant(0.8), total - 48.0}, 3);
  // Close along the fence.
  addWalker(world, random, {way.shifted(2.0), SpeedProfile::constant(0.3), 33.0});
  world.addMover(makeCyclist(), {back.shifted(1.7), SpeedProfile::constant(3.0), total - 75.0});
  world.park(makePedestrian(random), 20.4, -3.9, 1.5);
}

}  // namespace

void buildSteepHills(World& world, RandomStream& random) {
  const Path way(kWay, 6.0);
  addHill(world, way);
  addPlants(world, random, way);
  addPeople(world, random, way);
  makeLegged(world, way, 1.0, 22.0);
}

}  // namespace toss::simulation
