// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/SensorModel.h>

#include "Mesh.h"
#include "Sweep.h"
#include "World.h"

namespace toss::simulation {

/// A level road at z = 0 that reaches 200 m in all directions.
inline World levelWorld() {
  World world;
  const Surface road{semantics::kRoad, Material::Asphalt};
  world.add(gridMesh(
      gridLines(-200.0, 200.0, 50.0), gridLines(-200.0, 200.0, 50.0),
      [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); },
      [road](double, double) { return road; }));
  return world;
}

/// Makes the carrier drive along x at a speed [m/s], through x = 0 at time 0.
inline void drive(World& world, double speed) {
  world.carrier.motion = {Path({{0.0, 0.0}, {50.0, 0.0}}), SpeedProfile::constant(speed), 0.0};
}

/// One revolution around time 0.
inline SweepReturns revolution(const World& world, const SensorModel& sensor,
                               const SweepSettings& settings) {
  RayCaster caster(world);
  SweepReturns returns;
  sweep(world, caster, sensor, settings, 0.0, 7, returns);
  return returns;
}

}  // namespace toss::simulation
