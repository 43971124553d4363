// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Mesh.h"
#include "../Random.h"

namespace toss::simulation {

/// A house front along x from 0 to `length` at y = 0 with `depth` behind it (towards +y): recessed
/// windows and doors, a roof that overhangs by 0.5 m, balconies by chance. [m]
Mesh makeHouse(RandomStream& random, double length, double depth, double height);

/// A plain wall along x from 0 to `length`. [m]
Mesh makeWall(double length, double height, double thickness = 0.3);

/// A fence along x: posts, rails and wire. [m]
Mesh makeFence(double length, double height = 1.2);

/// Roof on posts, 2.5 m above the ground: a bus stop. [m]
Mesh makeShelter();

/// A bridge deck along y across the way, with its underside at `clearance`. [m]
Mesh makeBridge(double width, double span, double clearance);

/// Street lamp with an arm over the road (towards +y).
Mesh makeLamp();

/// Sign of retroreflecting sheet on a thin pole, facing -x.
Mesh makeSign();

/// Traffic light on a pole, facing -x.
Mesh makeTrafficLight();

/// Bollard of 0.9 m.
Mesh makeBollard();

/// Park bench along x.
Mesh makeBench();

/// Flight of stairs upwards along x: steps of rise and run, width along y; from the origin. [m]
Mesh makeStairs(int steps, double rise, double run, double width);

/// Crash barrier along x from 0 to `length`.
Mesh makeGuardRail(double length);

}  // namespace toss::simulation
