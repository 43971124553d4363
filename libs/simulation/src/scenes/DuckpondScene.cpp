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

/// The pond's middle and half-axes, which give back nothing; the path runs around it. [m]
const Eigen::Vector2d kPond(22.0, 16.0), kPondAxes(16.0, 10.0);

const std::vector<Eigen::Vector2d> kWay = {{-40.0, -2.0}, {0.0, 0.0},   {24.0, 1.0},
                                           {42.0, 8.0},   {46.0, 24.0}, {40.0, 60.0}};

/// 1 on the shore, less inside.
double pondRadius(double x, double y) {
  return (Eigen::Vector2d(x, y) - kPond).cwiseQuotient(kPondAxes).norm();
}

double parkHeight(double x, double y) {
  const double shore = std::max(0.0, 1.15 - pondRadius(x, y));
  return 0.15 * std::sin(x / 9.0) + 0.12 * std::cos(y / 7.0 + 0.5) - 2.0 * shore;
}

double distanceToWay(const Path& way, double x, double y) {
  double nearest = 1e9;
  for (double s = 0.0; s < way.length(); s += 1.0) {
    nearest = std::min(nearest, (way.position(s) - Eigen::Vector2d(x, y)).norm());
  }
  return nearest;
}

void addGround(World& world, const Path& way) {
  world.groundHeight = parkHeight;
  const Mesh all = gridMesh(
      gridLines(-50.0, 90.0, 0.7), gridLines(-45.0, 80.0, 0.7),
      [](double x, double y) { return Eigen::Vector3d(x, y, parkHeight(x, y)); },
      [&](double x, double y) {
        return distanceToWay(way, x, y) < 2.2 ? Surface{semantics::kSidewalk, Material::Soil}
                                              : Surface{semantics::kTerrain, Material::Grass};
      });
  Mesh land;
  land.vertices = all.vertices;
  for (std::size_t i = 0; i < all.triangles.size(); ++i) {
    const Eigen::Vector3f& corner = all.vertices[all.triangles[i][0]];
    if (pondRadius(static_cast<double>(corner.x()), static_cast<double>(corner.y())) < 1.0)
      continue;
    land.triangles.push_back(all.triangles[i]);
    land.surfaces.push_back(all.surfaces[i]);
  }
  world.add(land);
}

/// Trees, bushes and tall grass wherever there is neither path nor water.
void addPlants(World& world, RandomStream& random, const Path& way) {
  for (int plant = 0; plant < 190; ++plant) {
    const double x = random.uniform(-40.0, 80.0), y = random.uniform(-35.0, 65.0);
    const double far = distanceToWay(way, x, y);
    if (far < 3.2 || pondRadius(x, y) < 1.1) continue;
    const int kind = random.index(10);
    if (kind < 3 && far > 4.5) {
      world.place(makeTree(random, random.uniform(4.0, 10.0), 1000), x, y);
    } else if (kind < 4 && far > 5.0) {
      world.place(makeConifer(random, random.uniform(3.0, 7.0)), x, y);
    } else if (kind < 7) {
      world.place(makeAnyBush(random, 1.3, 1.8), x, y);
    } else {
      world.place(makeTallGrass(random, random.uniform(0.6, 2.0), 25), x, y);
    }
  }
  world.place(makeHedge(random, 22.0, 0.9, 1.4), -22.0, 1.6, 0.05);
  world.place(makeFence(24.0, 1.0), 8.0, 3.4, 0.04);
  for (double x : {-8.0, 4.0, 16.0}) world.place(makeBench(), x, -2.7, M_PI + 0.04);
  for (double x : {-15.0, 10.0, 30.0}) world.place(makeLamp(), x, -3.3);
}

void addPeople(World& world, RandomStream& random, const Path& way) {
  const Path back({kWay.rbegin(), kWay.rend()}, 10.0);
  const double total = way.length();
  addWalkersInLine(world, random, way, -0.9, 44.0, 6, 0.7, 1.3);
  addWalkersInLine(world, random, way, -1.7, 30.0, 7, 0.8, 1.5);
  addWalkersInLine(world, random, back, -0.9, total - 75.0, 6, 0.7, 1.3);
  addWalkersInLine(world, random, back, -1.7, total - 80.0, 8, 0.3, 1.4);
  addWalkersInLine(world, random, back, -2.3, total - 62.0, 4, 0.3, 0.6);
  addGroup(world, random, {way.shifted(-3.6), SpeedProfile::constant(1.0), 36.0}, 5);
  // Children run over the grass.
  for (double y : {-9.0, -12.5}) {
    world.addMover(makePedestrian(1.2, 1.3), walk(-4.0, y, 60.0, y + 4.0, 2.2));
  }
  // Close along the hedge.
  addWalker(world, random, walk(-20.0, 0.75, 40.0, 0.9, 0.9));
  for (const auto& [x, y] : {std::pair{4.3, -2.0}, {-9.0, -4.0}, {-9.8, -3.6}}) {
    world.park(makePedestrian(random), x, y, 1.5);
  }
}

}  // namespace

void buildDuckpond(World& world, RandomStream& random) {
  const Path way(kWay, 10.0);
  addGround(world, way);
  addPlants(world, random, way);
  addPeople(world, random, way);
  makeLegged(world, way, 0.9, 36.0);
}

}  // namespace toss::simulation
