// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../World.h"

namespace toss::simulation {

/// Makes the carrier a legged robot as large as a dog, with its sensor 0.55 m over the ground, that
/// follows `path` at `speed` [m/s] from `start` [m] on.
inline void makeLegged(World& world, const Path& path, double speed, double start) {
  world.carrier.motion = {path, SpeedProfile::constant(speed), start};
  world.carrier.sensorHeight = 0.55;
  world.carrier.bounce = 0.012, world.carrier.roll = 0.025, world.carrier.pitch = 0.02;
  world.carrier.step = 0.22;
}

}  // namespace toss::simulation
