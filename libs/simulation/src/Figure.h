// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <vector>

#include "Mesh.h"

namespace toss::simulation {

/// An object made of rigid parts: origin on the ground below its middle, x ahead.
struct Figure {
  /// Meshes in their own frames.
  std::vector<Mesh> parts;
  /// Pose of a part in the figure after `distance` [m] of travel at `time` [s]; empty = identity.
  std::function<Eigen::Isometry3d(std::size_t part, double distance, double time)> articulation;
  /// Full extents in rest pose [m]: length, width, height.
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  /// Classes while it never moves and if it ever does.
  std::uint16_t stillLabel = 0, movingLabel = 0;

  Eigen::Isometry3d partPose(std::size_t part, double distance, double time) const {
    return articulation ? articulation(part, distance, time) : Eigen::Isometry3d::Identity();
  }
};

}  // namespace toss::simulation
