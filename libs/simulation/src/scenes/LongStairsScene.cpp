// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "../objects/People.h"
#include "../objects/Structures.h"
#include "../objects/Vegetation.h"
#include "Rows.h"
#include "SceneBuilders.h"
#include "Trail.h"

namespace toss::simulation {
namespace {

/// Flights of steps with landings between them, upwards along x from 0.
constexpr int kFlights = 6, kSteps = 14;
constexpr double kRise = 0.16, kRun = 0.29, kLanding = 2.6, kWidth = 6.0;
constexpr double kFlight = kSteps * kRun, kPitch = kFlight + kLanding;
constexpr double kTop = kFlights * kPitch;

/// Height of the line on which one climbs.
double climb(double x) {
  if (x <= 0.0) return 0.0;
  const double flight = std::min(std::floor(x / kPitch), static_cast<double>(kFlights - 1));
  const double into = x - flight * kPitch;
  return kRise * kSteps * (flight + std::clamp(into / kFlight, 0.0, 1.0));
}

double slopeHeight(double x, double y) {
  const double beside = std::max(0.0, std::abs(y) - 0.5 * kWidth - 0.4);
  return climb(x) + std::min(1.2, 0.2 * beside) * (x > -1.0 && x < kTop ? 1.0 : 0.3);
}

void addFlights(World& world) {
  const Surface stone{semantics::kOtherGround, Material::Concrete};
  for (int flight = 0; flight < kFlights; ++flight) {
    const double x = flight * kPitch, z = kRise * kSteps * flight, top = z + kRise * kSteps;
    world.add(makeStairs(kSteps, kRise, kRun, kWidth), planarPose(x, 0.0, z, 0.0));
    Mesh landing;
    landing.addQuad({x + kFlight, -0.5 * kWidth, top}, {x + kPitch, -0.5 * kWidth, top},
                    {x + kPitch, 0.5 * kWidth, top}, {x + kFlight, 0.5 * kWidth, top}, stone);
    world.add(landing);
  }
}

/// Walls with handrails on both sides of the stairs, step by step upwards.
void addCheeks(World& world) {
  const Surface wall{semantics::kOtherStructure, Material::Concrete};
  const Surface rail{semantics::kFence, Material::Metal};
  Mesh mesh;
  for (double side : {-1.0, 1.0}) {
    const double y = side * (0.5 * kWidth + 0.15);
    for (double x = 0.0; x < kTop; x += 1.0) {
      const double z = climb(x), z2 = climb(x + 1.0);
      mesh.addQuad({x, y - 0.15 * side, z - 0.6}, {x + 1, y - 0.15 * side, z2 - 0.6},
                   {x + 1, y - 0.15 * side, z2 + 0.5}, {x, y - 0.15 * side, z + 0.5}, wall);
      mesh.addQuad({x, y - 0.15, z + 0.5}, {x + 1, y - 0.15, z2 + 0.5}, {x + 1, y + 0.15, z2 + 0.5},
                   {x, y + 0.15, z + 0.5}, wall);
      mesh.addBar({x, y, z + 1.0}, {x + 1, y, z2 + 1.0}, 0.03, 0.03, rail, 5);
      mesh.addBar({x, y, z + 0.4}, {x, y, z + 1.0}, 0.02, 0.02, rail, 5);
    }
  }
  world.add(mesh);
}

void addSlopes(World& world) {
  world.groundHeight = slopeHeight;
  const auto point = [](double x, double y) { return Eigen::Vector3d(x, y, slopeHeight(x, y)); };
  const auto surface = [](double x, double y) {
    const bool square = std::abs(y) < 0.5 * kWidth + 2.0 && (x < 0.0 || x > kTop);
    return square ? Surface{semantics::kSidewalk, Material::Concrete}
                  : Surface{semantics::kTerrain, Material::Grass};
  };
  const double edge = 0.5 * kWidth + 0.3;
  world.add(gridMesh(gridLines(-30.0, 0.0, 1.0), gridLines(-35.0, 35.0, 1.0), point, surface));
  world.add(
      gridMesh(gridLines(kTop, kTop + 30.0, 1.0), gridLines(-35.0, 35.0, 1.0), point, surface));
  world.add(gridMesh(gridLines(0.0, kTop, 0.7), gridLines(edge, 35.0, 1.0), point, surface));
  world.add(gridMesh(gridLines(0.0, kTop, 0.7), gridLines(-35.0, -edge, 1.0), point, surface));
}

void addSurroundings(World& world, RandomStream& random) {
  for (int plant = 0; plant < 90; ++plant) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double x = random.uniform(-25.0, kTop + 25.0), y = side * random.uniform(4.4, 25.0);
    if (random.chance(0.35)) {
      world.place(makeTree(random, random.uniform(4.0, 9.0), 900), x, side * (std::abs(y) + 1.5));
    } else {
      world.place(makeAnyBush(random, 0.9, 1.6), x, y);
    }
  }
  // An arch over the stairs, and a house at the top.
  const double x = 2.5 * kPitch;
  world.add(makeBridge(3.0, kWidth + 1.0, 3.4), planarPose(x, 0.0, climb(x), 0.0));
  world.place(makeHouse(random, 26.0, 9.0, 8.0), kTop + 22.0, 13.0, -0.5 * M_PI);
  for (double lamp : {-6.0, 1.0 * kPitch - 1.0, 3.0 * kPitch - 1.0, 5.0 * kPitch - 1.0}) {
    world.place(makeLamp(), lamp, -0.5 * kWidth - 0.8);
  }
  world.place(makeBench(), -5.0, 4.2);
}

void addPeople(World& world, RandomStream& random) {
  const Path up({{-30.0, 0.0}, {120.0, 0.0}}), down({{90.0, 0.0}, {-60.0, 0.0}});
  addWalkersInLine(world, random, up, -1.1, 33.5, 4, 0.5, 0.8);
  addWalkersInLine(world, random, up, -2.6, 26.0, 5, 0.5, 0.9);
  addWalkersInLine(world, random, down, -1.2, 52.0, 6, 0.6, 0.9);
  addWalkersInLine(world, random, down, -2.6, 50.0, 4, 0.3, 0.7);
  addGroup(world, random, {down.shifted(-1.9), SpeedProfile::constant(0.8), 86.0}, 2);
  world.park(makePedestrian(random), 2.0 * kPitch - 1.2, -2.5, 1.57);
  world.park(makePedestrian(random), -4.6, 3.4, -1.5);
}

}  // namespace

void buildLongStairs(World& world, RandomStream& random) {
  addSlopes(world);
  addFlights(world);
  addCheeks(world);
  addSurroundings(world, random);
  addPeople(world, random);
  makeLegged(world, Path({{-30.0, 0.2}, {120.0, 0.2}}), 0.7, 27.0);
}

}  // namespace toss::simulation
