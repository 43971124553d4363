// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "../World.h"

namespace toss::simulation {

/// A road along the x or the y axis. [m]
struct Road {
  bool alongX = true;
  /// Coordinate of its middle across it, and half its width between the kerbs.
  double center = 0.0, halfWidth = 3.5;
  /// Where it begins and ends along its axis.
  double low = -1e4, high = 1e4;
  /// Distance of a point from the kerb, negative on the road.
  double beyondKerb(double x, double y) const;
};

/// Roads with kerbs and pavements in gently uneven ground.
struct Town {
  std::vector<Road> roads;
  /// Extent of the ground. [m]
  double lowX = -60.0, highX = 120.0, lowY = -40.0, highY = 40.0;
  /// Height of kerbs and width of pavements. [m]
  double kerb = 0.12, pavement = 2.5;

  double height(double x, double y) const;
  Surface surface(double x, double y) const;
  /// Adds the ground to the world and makes it what everything stands on.
  void build(World& world) const;
};

}  // namespace toss::simulation
