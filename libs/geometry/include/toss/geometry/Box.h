// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace toss {

/// A box that stands upright: b = [c, theta, l, w, h] of the paper (section 3DMOT).
struct Box {
  /// Centre of the volume [m], map frame.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /// Rotation about the vertical axis [rad]; 0 for axis-aligned boxes, else in [-pi/2, pi/2).
  double yaw = 0.0;
  /// Full extents along the box's own x, y and z axes [m], not negative.
  double length = 0.0, width = 0.0, height = 0.0;

  double volume() const { return length * width * height; }
};

/// Area [m^2] of the intersection of the two footprints, exact for any yaw (spec section 5.5).
double footprintIntersection(const Box& a, const Box& b);

/// Intersection over union of the two volumes, in [0, 1]; 0 where both volumes are 0.
double intersectionOverUnion(const Box& a, const Box& b);

/// Whether the point [m, map frame] lies inside the box grown by `margin` [m] on every side.
bool contains(const Box& box, const Eigen::Vector3d& point, double margin = 0.0);

}  // namespace toss
