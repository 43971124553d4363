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

constexpr double kLow = -60.0, kHigh = 100.0;

void addFronts(World& world, RandomStream& random) {
  for (double side : {-1.0, 1.0}) {
    addHouses(world, random, rowBesideX(kLow, kHigh, side * 9.0), 8.0, 13.0);
    addRepeated(
        world, random, rowBesideX(kLow, kHigh, side * 6.0), 15.0,
        [&] { return makeTree(random, random.uniform(4.5, 7.0), 1100); }, 1.0);
    addRepeated(
        world, random, rowBesideX(kLow, kHigh, side * 5.6), 23.0, [] { return makeBench(); }, 3.0);
    addRepeated(world, random, rowBesideX(kLow, kHigh, side * 4.4), 8.0,
                [] { return makeBollard(); });
    addRepeated(world, random, rowBesideX(kLow + 6.0, kHigh, side * 5.2), 28.0,
                [] { return makeLamp(); });
  }
  addParkedCarsBesideX(world, random, 20.0, 52.0, -3.0, {30.4}, 0.9);
  world.place(makeShelter(), 8.0, 7.4);
  world.place(makeHedge(random, 14.0, 0.7, 1.1), 26.0, 5.2);
}

/// People who stand all the time, and stalls they stand at.
void addStanding(World& world, RandomStream& random) {
  for (double x : {-6.0, 14.0, 33.0}) {
    Mesh stall;
    stall.addBox({0, 0, 0.45}, {2.0, 0.9, 0.9}, {semantics::kOtherObject, Material::Bark});
    stall.addBox({0, 0, 2.3}, {2.6, 1.8, 0.08}, {semantics::kOtherStructure, Material::Cloth});
    for (double dx : {-1.2, 1.2}) {
      stall.addBar({dx, 0, 0}, {dx, 0, 2.3}, 0.03, 0.03, {semantics::kPole, Material::Metal}, 6);
    }
    world.place(stall, x, 7.2);
    world.park(makePedestrian(random), x + 0.4, 6.2, 1.4);
    world.park(makePedestrian(random), x - 0.5, 6.0, 1.8);
  }
}

void addWalkers(World& world, RandomStream& random) {
  const Path there({{-40.0, 0.0}, {160.0, 0.0}}), back({{120.0, 0.0}, {-80.0, 0.0}});
  addWalkersInLine(world, random, there, -8.6, 32.0, 6, 0.9, 1.3);  // along the wall
  addWalkersInLine(world, random, there, -7.3, 20.0, 7, 0.8, 1.5);
  addWalkersInLine(world, random, there, 2.4, 36.0, 5, 1.0, 1.4);
  addWalkersInLine(world, random, back, -8.5, 30.0, 6, 0.3, 1.2);  // along the other wall
  addWalkersInLine(world, random, back, -3.2, 40.0, 7, 0.8, 1.4);
  addWalkersInLine(world, random, back, 4.8, 45.0, 5, 0.9, 1.3);  // between the parked cars' side
  addWalker(world, random, walk(14.0, 3.9, 18.0, 3.9, 0.3));
  addGroup(world, random, {Path({{30.0, 1.7}, {-60.0, 1.7}}), SpeedProfile::constant(1.1), 0.0}, 4);
  addGroup(world, random, {Path({{-12.0, -2.6}, {100.0, -2.6}}), SpeedProfile::constant(1.9), 0.0},
           3);
  // Stops at a stall, stays, and goes on.
  addWalker(world, random,
            {Path({{10.0, 5.1}, {80.0, 5.1}}),
             SpeedProfile({{2.0, 1.2}, {3.0, 0.0}, {9.0, 0.0}, {10.0, 1.2}}), 0.0});
  // Crosses between two parked cars.
  addWalker(world, random, walk(30.4, -6.4, 30.4, 6.0, 0.8));
  world.addMover(makeCyclist(), walk(24.0, 1.1, -80.0, 1.1, 3.5));
  world.addMover(makeCyclist(), walk(-45.0, 1.4, 120.0, 1.4, 3.0));
}

}  // namespace

void buildPedestrians(World& world, RandomStream& random) {
  Town town;
  town.roads = {{true, 0.0, 4.6}};
  town.pavement = 5.0, town.kerb = 0.06;
  town.lowX = kLow - 20.0, town.highX = kHigh + 20.0, town.lowY = -30.0, town.highY = 30.0;
  town.build(world);
  addFronts(world, random);
  addStanding(world, random);
  addWalkers(world, random);
  world.carrier.motion = {Path({{0.0, -0.5}, {200.0, -0.5}}),
                          SpeedProfile({{0.0, 2.2}, {6.0, 2.5}, {9.0, 1.2}, {12.0, 2.5}}), 0.0};
}

}  // namespace toss::simulation
