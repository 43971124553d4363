// SPDX-License-Identifier: BSD-3-Clause
#include "Town.h"

#include <algorithm>
#include <cmath>

namespace toss::simulation {
namespace {

double beyondKerbOfAny(const std::vector<Road>& roads, double x, double y) {
  double distance = 1e9;
  for (const Road& road : roads) distance = std::min(distance, road.beyondKerb(x, y));
  return distance;
}

/// Unevenness of a few centimetres over tens of metres.
double undulation(double x, double y) {
  return 0.04 * std::sin(x / 11.0 + 0.3) + 0.03 * std::sin(y / 7.0 + x / 29.0);
}

}  // namespace

double Road::beyondKerb(double x, double y) const {
  const double along = alongX ? x : y, across = (alongX ? y : x) - center;
  const double beside = std::abs(across) - halfWidth;
  return std::max({beside, low - along, along - high});
}

double Town::height(double x, double y) const {
  const double beyond = beyondKerbOfAny(roads, x, y);
  return undulation(x, y) + (beyond > 0.0 ? kerb : 0.01 * std::min(4.0, -beyond));
}

Surface Town::surface(double x, double y) const {
  const double beyond = beyondKerbOfAny(roads, x, y);
  if (beyond < -0.005) return {semantics::kRoad, Material::Asphalt};
  if (beyond < pavement) return {semantics::kSidewalk, Material::Concrete};
  return {semantics::kTerrain, Material::Grass};
}

void Town::build(World& world) const {
  std::vector<double> edgesX, edgesY;
  for (const Road& road : roads) {
    std::vector<double>& across = road.alongX ? edgesY : edgesX;
    std::vector<double>& along = road.alongX ? edgesX : edgesY;
    for (double side : {-1.0, 1.0}) {
      across.push_back(road.center + side * road.halfWidth);
      across.push_back(road.center + side * (road.halfWidth + pavement));
    }
    for (double end : {road.low, road.high}) {
      if (std::abs(end) < 1e3) along.push_back(end);
    }
  }
  const auto self = *this;
  world.groundHeight = [self](double x, double y) { return self.height(x, y); };
  world.add(gridMesh(
      gridLines(lowX, highX, 1.5, edgesX), gridLines(lowY, highY, 1.5, edgesY),
      [&](double x, double y) { return Eigen::Vector3d(x, y, height(x, y)); },
      [&](double x, double y) { return surface(x, y); }));
}

}  // namespace toss::simulation
