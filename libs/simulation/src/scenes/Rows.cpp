// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../objects/People.h"
#include "../objects/Structures.h"
#include "../objects/Vegetation.h"
#include "../objects/Vehicles.h"

namespace toss::simulation {

using Eigen::Vector2d;

Vector2d Row::at(double along, double left) const {
  return {x + along * std::cos(yaw) - left * std::sin(yaw),
          y + along * std::sin(yaw) + left * std::cos(yaw)};
}

Row rowBesideX(double from, double to, double y) {
  return y >= 0.0 ? Row{from, y, 0.0, to - from} : Row{to, y, M_PI, to - from};
}

Row rowBesideY(double from, double to, double x) {
  return x <= 0.0 ? Row{x, from, 0.5 * M_PI, to - from} : Row{x, to, -0.5 * M_PI, to - from};
}

void addHouses(World& world, RandomStream& random, const Row& row, double lowest, double highest) {
  double along = 0.0;
  while (along < row.length - 6.0) {
    const double length = std::min(random.uniform(9.0, 24.0), row.length - along);
    const Vector2d p = row.at(along, random.uniform(0.0, 1.0));
    const double depth = random.uniform(8.0, 11.0), height = random.uniform(lowest, highest);
    world.place(makeHouse(random, length, depth, height), p.x(), p.y(), row.yaw);
    along += length + (random.chance(0.3) ? 0.0 : random.uniform(1.0, 3.0));
  }
}

void addParkedCars(World& world, RandomStream& random, const Row& row, double taken) {
  double along = 0.0;
  while (true) {
    const Figure car = makeCar(random);
    const double length = car.size.x();
    if (along + length > row.length) return;
    const Vector2d p = row.at(along + 0.5 * length, random.uniform(-0.1, 0.1));
    const bool turned = random.chance(0.1);
    const double yaw = row.yaw + random.uniform(-0.02, 0.02) + (turned ? M_PI : 0.0);
    if (random.chance(taken)) world.park(car, p.x(), p.y(), yaw);
    along += length + random.uniform(0.45, 0.7);
  }
}

void addParkedCarsBesideX(World& world, RandomStream& random, double from, double to, double y,
                          const std::vector<double>& openings, double taken) {
  constexpr double kHalfOpening = 0.8;
  for (double opening : openings) {
    if (opening <= from || opening >= to) continue;
    addParkedCars(world, random, rowBesideX(from, opening - kHalfOpening, y), taken);
    from = opening + kHalfOpening;
  }
  addParkedCars(world, random, rowBesideX(from, to, y), taken);
}

void addRepeated(World& world, RandomStream& random, const Row& row, double spacing,
                 const std::function<Mesh()>& make, double scatter) {
  for (double along = 0.5 * spacing; along < row.length; along += spacing) {
    const double ahead = random.uniform(-scatter, scatter);
    const Vector2d p = row.at(along + ahead, 0.3 * random.uniform(-scatter, scatter));
    world.place(make(), p.x(), p.y(), row.yaw);
  }
}

void addGardenEdges(World& world, RandomStream& random, const Row& row) {
  double along = 0.0;
  while (along < row.length - 3.0) {
    const double length = std::min(random.uniform(6.0, 14.0), row.length - along);
    const Vector2d p = row.at(along);
    const double height = random.uniform(1.0, 1.9);
    if (random.chance(0.6)) {
      world.place(makeHedge(random, length, 0.8, height), p.x(), p.y(), row.yaw);
    } else {
      world.place(makeFence(length, 0.8 * height), p.x(), p.y(), row.yaw);
    }
    along += length + random.uniform(1.0, 2.5);
  }
}

Motion walk(double fromX, double fromY, double toX, double toY, double speed) {
  return walk({{fromX, fromY}, {toX, toY}}, speed);
}

Motion walk(const std::vector<Vector2d>& waypoints, double speed) {
  return {Path(waypoints, 2.0), SpeedProfile::constant(speed), 0.0};
}

void addWalker(World& world, RandomStream& random, Motion motion) {
  const double speed = std::abs(motion.speed.speed(1.0));
  const double stride = std::clamp(0.5 + 0.65 * speed, 0.6, 1.6);
  motion.start += random.uniform(0.0, stride);
  world.addMover(makePedestrian(random.uniform(1.5, 1.9), stride), std::move(motion));
}

void addGroup(World& world, RandomStream& random, const Motion& motion, int count) {
  for (int person = 0; person < count; ++person) {
    Motion own = motion;
    own.path = motion.path.shifted(0.65 * (person % 3) + random.uniform(-0.1, 0.1));
    own.start -= 2.2 * (person / 3) + random.uniform(0.0, 0.3);
    addWalker(world, random, own);
  }
}

void addWalkersInLine(World& world, RandomStream& random, const Path& path, double left,
                      double start, int count, double slowest, double fastest) {
  const Path own = path.shifted(left);
  for (int person = 0; person < count; ++person) {
    const double speed = slowest + (fastest - slowest) * person / count;
    addWalker(world, random, {own, SpeedProfile::constant(speed), start});
    start += random.uniform(1.5, 7.0);
  }
}

}  // namespace toss::simulation
