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

/// Middle of the street into which the robot turns, and half the gap it leaves in the rows.
constexpr double kCross = 50.0, kGap = 9.0;
constexpr double kParking = 4.7;

void addMainStreet(World& world, RandomStream& random) {
  for (double side : {-1.0, 1.0}) {
    for (const auto& [from, to] : {std::pair{-80.0, kCross - kGap}, {kCross + kGap, 130.0}}) {
      addHouses(world, random, rowBesideX(from, to, side * 9.4), 9.0, 16.0);
      addRepeated(world, random, rowBesideX(from, to, side * 6.2), 26.0, [] { return makeLamp(); });
      addRepeated(
          world, random, rowBesideX(from + 9.0, to, side * 6.8), 19.0,
          [&] { return makeTree(random, random.uniform(5.0, 8.0), 1100); }, 1.0);
      addRepeated(world, random, rowBesideX(from + 14.0, to, side * 5.95), 33.0,
                  [] { return makeSign(); });
    }
    addParkedCars(world, random, rowBesideX(kCross + kGap + 4.0, 125.0, side * kParking));
  }
  addParkedCars(world, random, rowBesideX(-75.0, 18.0, kParking));
  // On the left a place is free for the car that arrives, on the right one for the car that leaves.
  addParkedCars(world, random, rowBesideX(-75.0, -2.0, -kParking), 0.95);
  addParkedCarsBesideX(world, random, 20.5, kCross - kGap - 6.0, -kParking, {25.6}, 0.95);
  world.place(makeBridge(5.0, 18.6, 4.6), -28.0, 0.0);
  world.place(makeBench(), 6.0, 8.6);
  world.place(makeShelter(), 74.0, -7.6, M_PI);
}

void addCrossStreet(World& world, RandomStream& random) {
  for (double side : {-1.0, 1.0}) {
    for (const auto& [from, to] : {std::pair{-80.0, -22.0}, {22.0, 110.0}}) {
      Row houses = rowBesideY(from, to, side * 9.0);
      Row cars = rowBesideY(from, to, side * kParking);
      Row lamps = rowBesideY(from, to, side * 6.1);
      for (Row* row : {&houses, &cars, &lamps}) row->x += kCross;
      addHouses(world, random, houses, 9.0, 16.0);
      addParkedCars(world, random, cars);
      addRepeated(world, random, lamps, 24.0, [] { return makeLamp(); });
    }
  }
}

/// A car that pulls out, one that pulls in, and one whose door opens.
void addParkingTraffic(World& world) {
  const std::vector<Eigen::Vector2d> out = {
      {11.5, -kParking}, {15.5, -kParking}, {21.5, -1.75}, {27.0, -1.75}, {200.0, -1.75}};
  world.addMover(makeCar(CarBody::Hatchback, Material::LightPaint),
                 {Path(out, 3.0), SpeedProfile({{0.5, 0.0}, {4.5, 7.5}}), 0.0});
  const std::vector<Eigen::Vector2d> in = {
      {70.0, 1.75}, {40.0, 1.75}, {32.0, 1.75}, {25.5, kParking}, {22.0, kParking}};
  world.addMover(makeCar(CarBody::Estate, Material::DarkPaint),
                 {Path(in, 3.0), SpeedProfile({{1.0, 7.0}, {7.0, 0.0}}), 20.0});
  world.park(makeCar(CarBody::Sedan, Material::LightPaint), 2.6, -kParking, 0.0);
  world.addMover(makeCarDoor(0.6),
                 {Path({{3.4, -3.82}, {4.4, -3.82}}), SpeedProfile::constant(0.0), 0.0});
}

void addTraffic(World& world, RandomStream& random) {
  world.addMover(makeBus(), walk(100.0, 1.75, -200.0, 1.75, 7.0));
  world.addMover(makeCar(random), walk(150.0, 1.75, -200.0, 1.75, 7.4));
  world.addMover(makeCar(random), walk(kCross + 1.75, -30.0, kCross + 1.75, 200.0, 9.0));
  world.addMover(makeCar(random), walk(kCross - 1.75, 46.0, kCross - 1.75, -200.0, 8.0));
  world.addMover(makeTruck(8.0), walk(kCross - 1.75, 95.0, kCross - 1.75, -200.0, 6.5));
  world.addMover(makeCar(random), walk(kCross - 1.75, 140.0, kCross - 1.75, -200.0, 9.0));
  world.addMover(makeCyclist(), walk(kCross + 3.2, 8.0, kCross + 3.2, 200.0, 4.0));
  world.addMover(makeCyclist(), walk(60.0, 3.3, -60.0, 3.3, 5.0));
}

void addPeople(World& world, RandomStream& random) {
  // Close along the house fronts on either side.
  addWalker(world, random, walk(-8.0, -8.9, 60.0, -8.9, 1.4));
  addWalker(world, random, walk(38.0, 8.9, -30.0, 8.9, 1.1));
  addGroup(world, random, walk(30.0, -7.5, -40.0, -7.5, 1.2), 2);
  // Steps out between parked cars and crosses behind the robot.
  addWalker(world, random, walk({{25.0, -8.2}, {25.6, -6.2}, {25.6, 2.0}, {25.6, 8.2}}, 0.7));
  // Along the gap between the parked cars and the kerb's trees.
  addWalker(world, random, walk(10.0, 6.0, 45.0, 6.0, 1.3));
  const double x = kCross + 7.0;
  addGroup(world, random, walk(x, 60.0, x, -20.0, 1.3), 4);
  addWalker(world, random, walk(kCross - 8.6, 12.0, kCross - 8.6, 90.0, 1.5));
  addWalker(world, random, walk(kCross - 7.2, 45.0, kCross - 7.2, 30.0, 0.3));
}

}  // namespace

void buildUrban(World& world, RandomStream& random) {
  Town town;
  town.roads = {{true, 0.0, 5.8}, {false, kCross, 5.8}};
  town.pavement = 3.8;
  town.lowX = -95.0, town.highX = 140.0, town.lowY = -90.0, town.highY = 120.0;
  town.build(world);
  addMainStreet(world, random);
  addCrossStreet(world, random);
  addParkingTraffic(world);
  addTraffic(world, random);
  addPeople(world, random);
  world.carrier.motion = {
      Path({{-14.0, -1.75}, {kCross + 1.75, -1.75}, {kCross + 1.75, 150.0}}, 10.0),
      SpeedProfile({{0.0, 7.0}, {5.0, 7.5}, {7.5, 4.5}, {10.0, 4.5}, {13.0, 8.0}}), 0.0};
}

}  // namespace toss::simulation
