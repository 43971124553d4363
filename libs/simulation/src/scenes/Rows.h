// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Random.h"
#include "../World.h"

namespace toss::simulation {

/// A straight line beside a road along which things are lined up: starts at x, y, runs in the
/// direction `yaw` for `length`; what has a back has it to the left. [m, rad]
struct Row {
  double x = 0.0, y = 0.0, yaw = 0.0, length = 0.0;

  /// Point `along` the row and `left` of it.
  Eigen::Vector2d at(double along, double left = 0.0) const;
};

/// The row along the x axis from `from` to `to` at `y`, running so that its left side is the one
/// away from the axis.
Row rowBesideX(double from, double to, double y);
/// The same along the y axis, at `x`.
Row rowBesideY(double from, double to, double x);

/// House after house with alleys of 1 to 3 m, some wall to wall.
void addHouses(World& world, RandomStream& random, const Row& row, double lowest = 5.0,
               double highest = 9.0);
/// Parked cars with gaps of half a metre, here and there a free place.
void addParkedCars(World& world, RandomStream& random, const Row& row, double taken = 0.85);
/// The same beside the x axis at `y`, with room at each of `openings` for people to cross.
void addParkedCarsBesideX(World& world, RandomStream& random, double from, double to, double y,
                          const std::vector<double>& openings, double taken = 0.85);
/// Any mesh made anew at each place, every `spacing` m with some scatter.
void addRepeated(World& world, RandomStream& random, const Row& row, double spacing,
                 const std::function<Mesh()>& make, double scatter = 0.0);
/// Hedges and fences by turns, as in front of gardens.
void addGardenEdges(World& world, RandomStream& random, const Row& row);

/// Straight motion from one point towards another at constant speed [m/s], started at time 0.
Motion walk(double fromX, double fromY, double toX, double toY, double speed);
/// The same along several points.
Motion walk(const std::vector<Eigen::Vector2d>& waypoints, double speed);
/// Pedestrian whose stride suits the speed.
void addWalker(World& world, RandomStream& random, Motion motion);
/// `count` people who walk together.
void addGroup(World& world, RandomStream& random, const Motion& motion, int count);

/// People one after the other along a path, `left` of it: the first at `start`, the next 1.5 to 7 m
/// ahead and a little faster, so that nobody walks through anybody. [m, m/s]
void addWalkersInLine(World& world, RandomStream& random, const Path& path, double left,
                      double start, int count, double slowest, double fastest);

}  // namespace toss::simulation
