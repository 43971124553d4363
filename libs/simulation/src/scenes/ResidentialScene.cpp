// SPDX-License-Identifier: BSD-3-Clause
#include "../objects/People.h"
#include "../objects/Structures.h"
#include "../objects/Vegetation.h"
#include "../objects/Vehicles.h"
#include "Rows.h"
#include "SceneBuilders.h"
#include "Town.h"

namespace toss::simulation {
namespace {

constexpr double kLow = -70.0, kHigh = 130.0;
/// A narrow street: parked cars stand at the right, hedges and fences close behind the pavements.
constexpr double kHalfRoad = 4.2, kHedge = 6.6;
/// Middle of a drive on the left, out of which a car comes.
constexpr double kDrive = -9.5;

/// Hedges, trees and bushes of the gardens on one side.
void addGarden(World& world, RandomStream& random, double from, double to, double side) {
  const auto tree = [&] {
    return random.chance(0.4) ? makeConifer(random, random.uniform(3.0, 7.0))
                              : makeTree(random, random.uniform(4.0, 9.0));
  };
  addGardenEdges(world, random, rowBesideX(from, to, side * kHedge));
  addRepeated(world, random, rowBesideX(from, to, side * 10.0), 13.0, tree, 4.0);
  addRepeated(
      world, random, rowBesideX(from, to, side * 8.4), 6.0,
      [&] { return makeAnyBush(random, 1.1, 1.6); }, 2.5);
}

void addGardens(World& world, RandomStream& random) {
  addGarden(world, random, kLow, kHigh, -1.0);
  addGarden(world, random, kLow, kDrive - 2.5, 1.0);
  addGarden(world, random, kDrive + 2.5, kHigh, 1.0);
  for (double side : {-1.0, 1.0}) {
    addHouses(world, random, rowBesideX(kLow, kHigh, side * 14.0), 4.5, 7.0);
    addRepeated(world, random, rowBesideX(kLow + 10.0, kHigh, side * 4.5), 36.0,
                [] { return makeLamp(); });
  }
  addRepeated(world, random, rowBesideX(kLow, kHigh, -4.5), 45.0, [] { return makeSign(); });
}

void addCars(World& world, RandomStream& random) {
  addParkedCarsBesideX(world, random, kLow, 26.0, -3.2, {20.4});
  addParkedCars(world, random, rowBesideX(38.0, kHigh, -3.2));
  addParkedCars(world, random, rowBesideX(-30.0, kDrive - 3.0, 3.3), 0.5);
  addParkedCars(world, random, rowBesideX(kDrive + 3.0, 8.0, 3.3), 0.5);
  // Leaves its place in front of the robot, leads it, and stops again.
  world.addMover(
      makeCar(CarBody::Hatchback, Material::LightPaint),
      {Path({{31.5, -3.2}, {34.5, -3.2}, {39.5, -0.9}, {46.0, -0.7}, {300.0, -0.7}}, 2.5),
       SpeedProfile({{1.0, 0.0}, {3.5, 6.0}, {7.5, 6.0}, {9.0, 3.0}}), 0.0});
  world.addMover(makeCar(CarBody::Van, Material::LightPaint), walk(110.0, 1.9, -200.0, 1.9, 6.0));
  // Stands in a drive and reverses into the street behind the robot.
  world.addMover(makeCar(CarBody::Estate, Material::DarkPaint),
                 {Path({{kDrive, -1.2}, {kDrive, 10.0}}),
                  SpeedProfile({{3.0, 0.0}, {4.5, -1.6}, {8.1, -1.6}, {8.6, 0.0}}), 10.5});
}

void addPeople(World& world, RandomStream& random) {
  // Close along the hedges, one very slowly.
  addWalker(world, random, walk(2.0, -5.85, 60.0, -5.85, 1.2));
  addWalker(world, random, walk(24.0, 5.85, 0.0, 5.85, 0.3));
  addGroup(world, random, walk(50.0, 4.8, -30.0, 4.8, 1.3), 2);
  addWalker(world, random, walk({{19.0, -5.6}, {20.4, -4.6}, {20.4, 0.0}, {21.0, 6.0}}, 0.8));
  addWalker(world, random, walk(64.0, -5.2, 0.0, -5.2, 1.5));
  world.addMover(makeCyclist(), walk(-16.0, -0.9, 200.0, -0.9, 4.2));
  world.addMover(makeCyclist(), walk(75.0, 1.5, -60.0, 1.5, 5.0));
}

}  // namespace

void buildResidential(World& world, RandomStream& random) {
  Town town;
  town.roads = {{true, 0.0, kHalfRoad}};
  town.pavement = 1.7, town.kerb = 0.10;
  town.lowX = kLow - 20.0, town.highX = kHigh + 20.0, town.lowY = -45.0, town.highY = 45.0;
  town.build(world);
  addGardens(world, random);
  addCars(world, random);
  addPeople(world, random);
  world.carrier.motion = {Path({{0.0, -0.7}, {300.0, -0.7}}),
                          SpeedProfile({{0.0, 5.5}, {2.0, 5.0}, {4.0, 4.5}, {9.0, 5.0}}), 0.0};
}

}  // namespace toss::simulation
