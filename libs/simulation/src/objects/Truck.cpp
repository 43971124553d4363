// SPDX-License-Identifier: BSD-3-Clause
#include "Vehicles.h"

namespace toss::simulation {
namespace {

/// Wheels of both sides at the given places along the vehicle.
void addWheels(Mesh& mesh, std::initializer_list<double> axles, double width, std::uint16_t label) {
  constexpr double kRadius = 0.5;
  for (double x : axles) {
    for (double side : {-1.0, 1.0}) {
      mesh.addBar({x, side * (0.5 * width - 0.3), kRadius}, {x, side * 0.5 * width, kRadius},
                  kRadius, kRadius, {label, Material::Rubber}, 10);
    }
  }
}

}  // namespace

Figure makeTruck(double length) {
  constexpr double kWidth = 2.5, kHeight = 3.6, kCab = 2.2;
  const std::uint16_t label = semantics::kTruck;
  const double front = 0.5 * length;
  const double cabMiddle = front - 0.5 * kCab;
  Mesh mesh;
  mesh.addBox({cabMiddle, 0.0, 1.25}, {kCab, kWidth, 1.6}, {label, Material::LightPaint});
  mesh.addBox({cabMiddle, 0.0, 2.4}, {kCab, kWidth - 0.1, 0.7}, {label, Material::Glass});
  mesh.addBox({cabMiddle - 0.2, 0.0, 2.85}, {kCab - 0.3, kWidth, 0.25},
              {label, Material::LightPaint});
  const double boxLength = length - kCab - 0.5;
  mesh.addBox({-front + 0.5 * boxLength, 0.0, 0.5 * (kHeight + 1.15)},
              {boxLength, kWidth, kHeight - 1.15}, {label, Material::LightPaint});
  mesh.addBox({0.0, 0.0, 0.95}, {length - 1.0, 0.9, 0.3}, {label, Material::Metal});
  addWheels(mesh, {front - 1.3, -front + 1.5, -front + 2.8}, kWidth, label);

  Figure figure;
  figure.size = {length, kWidth, kHeight};
  figure.parts = {std::move(mesh)};
  figure.stillLabel = label, figure.movingLabel = semantics::kMovingTruck;
  return figure;
}

Figure makeBus() {
  constexpr double kLength = 12.0, kWidth = 2.55, kHeight = 3.1;
  const std::uint16_t label = semantics::kBus;
  Mesh mesh;
  mesh.addBox({0.0, 0.0, 0.8}, {kLength, kWidth, 0.9}, {label, Material::LightPaint});
  mesh.addBox({0.0, 0.0, 1.85}, {kLength, kWidth - 0.04, 1.2}, {label, Material::Glass});
  mesh.addBox({0.0, 0.0, 2.775}, {kLength, kWidth, 0.65}, {label, Material::LightPaint});
  for (double x = -5.9; x < 6.0; x += 1.475) {
    for (double side : {-1.0, 1.0}) {
      mesh.addBox({x, side * 0.5 * kWidth, 1.85}, {0.12, 0.05, 1.2}, {label, Material::DarkPaint});
    }
  }
  for (double x = -4.5; x < 5.0; x += 0.9) {
    for (double y : {-0.8, 0.8}) {
      mesh.addBox({x, y, 1.2}, {0.15, 0.9, 0.9}, {label, Material::Cloth});
    }
  }
  addWheels(mesh, {3.6, -3.2}, kWidth, label);

  Figure figure;
  figure.size = {kLength, kWidth, kHeight};
  figure.parts = {std::move(mesh)};
  figure.stillLabel = label, figure.movingLabel = semantics::kMovingBus;
  return figure;
}

}  // namespace toss::simulation
