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

/// The robot's light turns green at this time [s]; the crossing traffic's has been green before.
constexpr double kGreen = 14.0;
constexpr double kHalfRoad = 7.0, kStopLine = -11.0;

/// Stands in a queue until its turn comes, then speeds up.
SpeedProfile waitUntil(double time, double speed) {
  return SpeedProfile({{0.0, 0.0}, {time, 0.0}, {time + speed / 2.0, speed}});
}

/// Comes up to the light and stops after `braking` s from `speed`, waits, goes on.
SpeedProfile stopAndGo(double speed, double until, double braking, double go) {
  return SpeedProfile(
      {{until - braking, speed}, {until, 0.0}, {go, 0.0}, {go + speed / 2.0, speed}});
}

void addCorners(World& world, RandomStream& random) {
  for (double sideX : {-1.0, 1.0}) {
    for (double sideY : {-1.0, 1.0}) {
      const double fromX = sideX < 0.0 ? -90.0 : 14.0, toX = sideX < 0.0 ? -14.0 : 120.0;
      addHouses(world, random, rowBesideX(fromX, toX, sideY * 14.0), 8.0, 14.0);
      addRepeated(
          world, random, rowBesideX(fromX, toX, sideY * 8.2), 22.0,
          [&] { return makeTree(random, random.uniform(6.0, 8.0)); }, 2.0);
      addRepeated(world, random, rowBesideX(fromX, toX, sideY * 7.6), 30.0,
                  [] { return makeLamp(); });
      const double fromY = sideY < 0.0 ? -90.0 : 30.0, toY = sideY < 0.0 ? -30.0 : 90.0;
      addHouses(world, random, rowBesideY(fromY, toY, sideX * 13.0), 8.0, 14.0);
      world.place(makeTrafficLight(), sideX * 8.0, sideY * 7.8, sideX < 0.0 ? 0.0 : M_PI);
      for (double step : {9.5, 11.0, 12.5}) {
        world.place(makeBollard(), sideX * step, sideY * 7.5);
      }
    }
  }
}

/// Vehicles before, beside and behind the robot at the light.
void addQueue(World& world, RandomStream& random) {
  world.addMover(makeCar(random), {Path({{kStopLine - 3.0, -1.75}, {200.0, -1.75}}),
                                   waitUntil(kGreen + 0.5, 9.0), 0.0});
  world.addMover(makeBus(), {Path({{kStopLine - 7.0, -4.95}, {200.0, -4.95}}),
                             waitUntil(kGreen + 0.2, 10.0), 0.0});
  world.addMover(makeCar(random), {Path({{-60.0, -5.25}, {-31.0, -5.25}, {200.0, -5.25}}),
                                   stopAndGo(8.0, 5.0, 3.0, kGreen + 4.0), 0.0});
  world.addMover(makeCar(random), {Path({{-84.0, -1.75}, {200.0, -1.75}}),
                                   stopAndGo(8.0, 7.5, 3.0, kGreen + 3.5), 0.0});
  // Oncoming: two wait as well, the second turns left behind the first.
  world.addMover(makeCar(random),
                 {Path({{14.0, 1.75}, {-200.0, 1.75}}), waitUntil(kGreen + 0.8, 9.0), 0.0});
  world.addMover(makeCar(random), {Path({{20.5, 1.75}, {-1.9, 1.75}, {-1.9, -120.0}}, 8.0),
                                   waitUntil(kGreen + 7.5, 6.0), 0.0});
  world.addMover(makeTruck(),
                 {Path({{16.0, 5.25}, {-200.0, 5.25}}), waitUntil(kGreen + 1.2, 7.0), 0.0});
}

/// Many vehicles that pass the same lane seconds apart, as long as the crossing road is green.
void addCrossingTraffic(World& world, RandomStream& random) {
  for (double start : {-15.0, -42.0, -60.0, -84.0}) {
    world.addMover(makeCar(random), walk(1.9, start, 1.9, 200.0, 9.0));
  }
  for (double start : {25.0, 46.0, 68.0, 95.0}) {
    world.addMover(makeCar(random), walk(-1.9, start, -1.9, -200.0, 10.0));
  }
  world.addMover(makeTruck(10.5), walk(5.2, -75.0, 5.2, 200.0, 8.0));
  // Those who come after the lights have changed wait at their line.
  for (double gap : {0.0, 7.0, 14.0}) {
    world.addMover(makeCar(random), {Path({{1.9, -120.0 - gap}, {1.9, -11.0 - gap}, {1.9, 200.0}}),
                                     SpeedProfile({{11.0, 8.0}, {15.0, 0.0}, {31.0, 0.0}}), 5.0});
  }
}

void addPeople(World& world, RandomStream& random) {
  addGroup(world, random, walk(9.2, -9.0, 9.2, 40.0, 1.2), 4);
  addGroup(world, random, walk(-9.2, -12.0, -9.2, 40.0, 1.3), 3);
  addWalker(world, random, walk(9.8, 14.0, 9.8, -30.0, 1.2));
  addWalker(world, random, walk(-40.0, 9.0, 30.0, 9.0, 1.4));
  addWalker(world, random, walk(-12.0, 13.3, -50.0, 13.3, 0.7));
  world.addMover(makeCyclist(), {Path({{-50.0, -6.72}, {200.0, -6.72}}),
                                 stopAndGo(5.0, 8.0, 2.0, kGreen + 0.3), 0.0});
  world.park(makePedestrian(1.75, 1.2), -8.6, -8.8, 1.0);
  world.place(makeShelter(), -24.0, -9.4, M_PI);
  world.place(makeBench(), 24.0, 10.5);
}

}  // namespace

void buildJunction(World& world, RandomStream& random) {
  Town town;
  town.roads = {{true, 0.0, kHalfRoad}, {false, 0.0, kHalfRoad}};
  town.lowX = -110.0, town.highX = 160.0, town.lowY = -100.0, town.highY = 100.0;
  town.build(world);
  addCorners(world, random);
  addQueue(world, random);
  addCrossingTraffic(world, random);
  addPeople(world, random);
  // Comes up to the light, waits behind the first car, follows it across the junction.
  world.carrier.motion = {
      Path({{-52.0, -1.75}, {200.0, -1.75}}),
      SpeedProfile({{2.0, 8.0}, {5.5, 0.0}, {kGreen + 1.8, 0.0}, {kGreen + 6.0, 7.0}}), 0.0};
}

}  // namespace toss::simulation
