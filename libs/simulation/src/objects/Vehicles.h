// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Figure.h"
#include "../Random.h"

namespace toss::simulation {

enum class CarBody { Sedan, Hatchback, Estate, Van };

/// A car of car shape: bonnet, cabin with glass, boot, wheels, clearance below; body, paint and
/// size by chance.
Figure makeCar(RandomStream& random);
Figure makeCar(CarBody body, Material paint);

/// One plain box of a car's size [m]: length, width, height.
Figure makeBoxCar(const Eigen::Vector3d& size);

/// Lorry with cab and a box body 3.6 m high.
Figure makeTruck(double length = 9.0);

/// City bus 12 m long and 3.1 m high, with a band of windows.
Figure makeBus();

/// A car's door in the y-z plane of its hinge, that opens at `openingTime` [s] within 1 s.
Figure makeCarDoor(double openingTime);

}  // namespace toss::simulation
