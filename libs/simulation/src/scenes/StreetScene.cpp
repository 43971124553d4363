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

constexpr double kLow = -45.0, kHigh = 110.0;
/// Middle of the street that crosses, and half the gap it leaves in the rows.
constexpr double kSideStreet = 48.0, kGap = 6.5;
/// Where a person crosses between parked cars.
constexpr double kCrossing = 20.2;

/// Everything on one side of the street: parked cars, trees, garden edges, houses.
void addSide(World& world, RandomStream& random, double side) {
  for (const auto& [from, to] :
       {std::pair{kLow, kSideStreet - kGap}, {kSideStreet + kGap, kHigh}}) {
    addParkedCarsBesideX(world, random, from, to - 4.0, side * 4.6, {kCrossing});
    addRepeated(
        world, random, rowBesideX(from, to, side * 6.0), 17.0,
        [&] { return makeTree(random, random.uniform(6.0, 9.0)); }, 1.0);
    addRepeated(world, random, rowBesideX(from, to, side * 5.9), 31.0, [] { return makeLamp(); });
    addRepeated(world, random, rowBesideX(from + 5.0, to, side * 5.85), 40.0,
                [] { return makeSign(); });
    addGardenEdges(world, random, rowBesideX(from, to, side * 8.6));
    addHouses(world, random, rowBesideX(from, to, side * 12.5));
  }
}

void addSideStreetHouses(World& world, RandomStream& random) {
  for (double side : {-1.0, 1.0}) {
    for (const auto& [from, to] : {std::pair{-60.0, -24.0}, {24.0, 60.0}}) {
      Row row = rowBesideY(from, to, side * 7.5);
      row.x += kSideStreet;
      addHouses(world, random, row);
    }
  }
}

void addVehicles(World& world) {
  world.addMover(makeCar(CarBody::Sedan, Material::LightPaint), walk(75.0, 1.75, -80.0, 1.75, 8.0));
  world.addMover(makeCar(CarBody::Hatchback, Material::DarkPaint),
                 walk(15.0, -1.75, 160.0, -1.75, 7.0));
  world.addMover(makeCar(CarBody::Estate, Material::LightPaint),
                 walk(kSideStreet + 1.6, -13.0, kSideStreet + 1.6, 70.0, 7.0));
  world.addMover(makeCyclist(), walk(7.0, -3.05, 120.0, -3.05, 4.5));
}

void addPeople(World& world, RandomStream& random) {
  addWalker(world, random, walk(18.0, 7.2, 60.0, 7.2, 1.3));
  addWalker(world, random, walk(30.0, -7.9, -30.0, -7.9, 1.1));
  addGroup(world, random, walk(36.0, 6.9, -40.0, 6.9, 1.4), 2);
  addWalker(world, random, walk({{12.0, -7.4}, {kCrossing, -7.4}, {kCrossing, 7.5}}, 1.5));
  addWalker(world, random, walk(-6.0, -7.0, 60.0, -7.0, 1.6));
}

}  // namespace

void buildStreet(World& world, RandomStream& random) {
  Town town;
  town.roads = {{true, 0.0, 5.5}, {false, kSideStreet, 3.5}};
  town.lowX = kLow - 20.0, town.highX = kHigh + 20.0, town.lowY = -65.0, town.highY = 65.0;
  town.build(world);
  for (double side : {-1.0, 1.0}) addSide(world, random, side);
  addSideStreetHouses(world, random);
  addVehicles(world);
  addPeople(world, random);
  world.carrier.motion = {Path({{0.0, -1.75}, {100.0, -1.75}}),
                          SpeedProfile({{0.0, 7.0}, {3.0, 7.6}, {6.0, 6.0}}), 0.0};
}

}  // namespace toss::simulation
