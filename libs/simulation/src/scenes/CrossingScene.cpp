// SPDX-License-Identifier: BSD-3-Clause
#include "../objects/People.h"
#include "../objects/Structures.h"
#include "../objects/Vehicles.h"
#include "Rows.h"
#include "SceneBuilders.h"

namespace toss::simulation {

void buildCrossing(World& world, RandomStream& random) {
  const Surface road{semantics::kRoad, Material::Asphalt};
  world.add(gridMesh(
      gridLines(-40.0, 60.0, 10.0), gridLines(-40.0, 40.0, 10.0),
      [](double x, double y) { return Eigen::Vector3d(x, y, 0.0); },
      [road](double, double) { return road; }));
  for (double side : {-20.0, 20.0}) world.place(makeWall(60.0, 9.0), -25.0, side);
  world.park(makeBoxCar({4.4, 1.8, 1.5}), 6.0, -7.0, 0.0);
  world.place(makeLamp(), 14.0, -5.0);

  world.addMover(makeBoxCar({4.2, 1.8, 1.5}), walk(12.0, -13.0, 12.0, 40.0, 6.0));
  addWalker(world, random, walk(5.0, 5.5, 30.0, 5.5, 1.3));
  world.carrier.motion = {Path({{0.0, 0.0}, {10.0, 0.0}}), SpeedProfile::constant(0.5), 0.0};
}

}  // namespace toss::simulation
