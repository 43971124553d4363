// SPDX-License-Identifier: BSD-3-Clause
#include "../objects/Structures.h"
#include "../objects/Vegetation.h"
#include "../objects/Vehicles.h"
#include "Rows.h"
#include "SceneBuilders.h"

namespace toss::simulation {
namespace {

constexpr double kLow = -160.0, kHigh = 430.0;
/// Edge of the carriageway of the robot and of the other, and the lanes' middles.
constexpr double kRight = -13.5, kLeft = 13.5;
constexpr double kLanes[] = {-10.0, -6.3, -2.6};

/// Gentle crests along the way and a ditch on either side.
double roadHeight(double x, double y) {
  const double beside = std::max(0.0, std::abs(y) - kLeft - 1.0);
  const double ditch = -0.8 * std::exp(-0.5 * std::pow((beside - 3.0) / 1.2, 2.0));
  const double bank = 0.25 * std::max(0.0, beside - 6.0);
  return 1.5 * std::sin(x / 90.0) + (beside > 0.0 ? ditch : 0.0) + std::min(5.0, bank);
}

void addGround(World& world) {
  world.groundHeight = roadHeight;
  world.add(gridMesh(
      gridLines(kLow, kHigh, 4.0), gridLines(-70.0, 70.0, 1.0),
      [](double x, double y) { return Eigen::Vector3d(x, y, roadHeight(x, y)); },
      [](double, double y) {
        const bool paved = std::abs(y) < kLeft && std::abs(y) > 0.9;
        return paved ? Surface{semantics::kRoad, Material::Asphalt}
                     : Surface{semantics::kTerrain, Material::Grass};
      }));
}

/// Guard rails follow the crests in pieces of 12 m.
void addRails(World& world, double y) {
  for (double x = kLow; x < kHigh; x += 12.0) {
    const double slope = std::atan2(roadHeight(x + 12.0, y) - roadHeight(x, y), 12.0);
    Eigen::Isometry3d pose = planarPose(x, y, roadHeight(x, y), 0.0);
    pose.rotate(Eigen::AngleAxisd(-slope, Eigen::Vector3d::UnitY()));
    world.add(makeGuardRail(12.0), pose);
  }
}

/// A sign gantry over the robot's carriageway.
void addGantry(World& world, double x) {
  const Surface metal{semantics::kPole, Material::Metal};
  Mesh gantry;
  for (double y : {-14.2, -0.2}) gantry.addBar({0, y, -0.5}, {0, y, 7.5}, 0.2, 0.2, metal, 8);
  gantry.addBox({0, -7.2, 7.3}, {0.5, 14.0, 0.5}, metal);
  for (double y : {-10.0, -4.5}) {
    gantry.addBox({-0.35, y, 6.6}, {0.05, 4.2, 2.2},
                  {semantics::kTrafficSign, Material::Retroreflector});
  }
  world.place(gantry, x, 0.0);
}

void addScenery(World& world, RandomStream& random) {
  for (double y : {kRight - 0.6, -0.4, 0.4, kLeft + 0.6}) addRails(world, y);
  for (double side : {-1.0, 1.0}) {
    addRepeated(
        world, random, rowBesideX(kLow, kHigh, side * 25.0), 11.0,
        [&] {
          return random.chance(0.3) ? makeConifer(random, random.uniform(6.0, 10.0))
                                    : makeTree(random, random.uniform(7.0, 11.0), 700);
        },
        4.0);
    addRepeated(
        world, random, rowBesideX(kLow, kHigh, side * 20.0), 9.0,
        [&] { return makeAnyBush(random, 1.6, 2.0); }, 4.0);
  }
  for (double x = 40.0; x < 130.0; x += 30.0) world.place(makeWall(30.0, 4.0, 0.2), x, kLeft + 2.0);
  addGantry(world, 70.0);
  addGantry(world, 290.0);
  world.place(makeBridge(9.0, 56.0, 6.0), 170.0, 0.0);
  for (double x = -100.0; x < kHigh; x += 50.0) world.place(makeBollard(), x, kRight - 1.4);
}

void addOncoming(World& world, RandomStream& random) {
  // Many vehicles seconds apart on each lane of the other carriageway.
  const double speeds[] = {24.0, 29.0, 34.0};
  for (int lane = 0; lane < 3; ++lane) {
    double x = 20.0 + 35.0 * lane;
    for (int car = 0; car < 6; ++car) {
      const bool truck = lane == 0 && car % 2 == 0;
      world.addMover(truck ? makeTruck(random.uniform(9.0, 14.0)) : makeCar(random),
                     walk(x, -kLanes[lane], -4000.0, -kLanes[lane], speeds[lane]));
      x += random.uniform(45.0, 90.0);
    }
  }
}

}  // namespace

void buildHighway(World& world, RandomStream& random) {
  addGround(world);
  addScenery(world, random);
  addOncoming(world, random);
  const auto ahead = [](double x, double y, double speed) { return walk(x, y, 4000.0, y, speed); };
  // Leading and following at the robot's own speed; overtaking; trucks that are overtaken.
  world.addMover(makeCar(CarBody::Sedan, Material::LightPaint), ahead(32.0, kLanes[1], 25.0));
  world.addMover(makeCar(CarBody::Estate, Material::DarkPaint), ahead(-28.0, kLanes[1], 25.3));
  world.addMover(makeCar(CarBody::Sedan, Material::DarkPaint), ahead(-55.0, kLanes[2], 34.0));
  world.addMover(makeCar(CarBody::Van, Material::LightPaint), ahead(-105.0, kLanes[2], 33.0));
  world.addMover(makeTruck(14.0), ahead(38.0, kLanes[0], 22.0));
  world.addMover(makeTruck(12.0), ahead(75.0, kLanes[0], 22.5));
  world.addMover(makeBus(), ahead(-20.0, kLanes[0], 24.0));
  world.carrier.motion = {Path({{0.0, kLanes[1]}, {4000.0, kLanes[1]}}),
                          SpeedProfile::constant(25.0), 0.0};
}

}  // namespace toss::simulation
