// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <vector>

#include "Figure.h"
#include "Mesh.h"
#include "Motion.h"

namespace toss::simulation {

/// Something of a class and an instance of its own that travels, or could.
struct Mover {
  Figure figure;
  Motion motion;
  std::uint16_t instance = 0;
};

/// Whoever carries the sensor.
struct Carrier {
  Motion motion{Path({{0.0, 0.0}, {1.0, 0.0}}), SpeedProfile::constant(0.0), 0.0};
  /// Height of the sensor over the ground [m].
  double sensorHeight = 1.73;
  /// Rocking of a legged robot per step: vertical [m], roll and pitch [rad], and length of a step
  /// [m]; 0 for wheels.
  double bounce = 0.0, roll = 0.0, pitch = 0.0, step = 0.35;
  /// Where the sensor sits, against its usual place (usual <- sensor).
  Eigen::Isometry3d mount = Eigen::Isometry3d::Identity();
};

/// All that the rays can meet. Ground at z = groundHeight(x, y); map frame [m].
struct World {
  /// Everything that never moves, with the instance of each triangle.
  Mesh still;
  std::vector<std::uint16_t> stillInstances;
  /// Objects among `still` that have an instance: parked cars, standing people.
  struct StillObject {
    std::uint16_t instance, label;
    Box box;
  };
  std::vector<StillObject> stillObjects;
  std::vector<Mover> movers;
  Carrier carrier;
  std::function<double(double x, double y)> groundHeight = [](double, double) { return 0.0; };

  /// Adds scenery in map coordinates.
  void add(const Mesh& mesh, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());
  /// Adds scenery that stands on the ground at x, y.
  void place(const Mesh& mesh, double x, double y, double yaw = 0.0);
  /// Adds an object with an instance that never moves.
  void park(const Figure& figure, double x, double y, double yaw);
  /// Adds an object that travels.
  void addMover(Figure figure, Motion motion);

  /// Where a mover's origin is.
  Eigen::Isometry3d poseOf(const Mover& mover, double time) const;
  /// Pose of the sensor (map <- sensor).
  Eigen::Isometry3d mapFromSensor(double time) const;
  /// Whether any part of the mover takes another pose at any of `count` times from `start` on.
  bool movesWithin(const Mover& mover, double start, double step, int count) const;

 private:
  std::uint16_t nextInstance_ = 1;
};

/// Box of a figure whose origin has that pose.
Box boxOf(const Figure& figure, const Eigen::Isometry3d& pose);

}  // namespace toss::simulation
