// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <Eigen/Geometry>
#include <cmath>

namespace toss {

/// An upright box in the level frame of a scan [m], ready to be tested.
struct ClaimFootprint {
  float x = 0, y = 0, cosYaw = 1, sinYaw = 0, halfLength = 0, halfWidth = 0, low = 0, high = 0;

  /// `box`: map frame; `sensorPosition`: origin of the level frame in the map. What is claimed may
  /// lie as much as `below` [m] under the box.
  ClaimFootprint(const Box& box, const Eigen::Vector3d& sensorPosition, double below);

  /// The rectangle along the axes around it, grown by `margin`.
  Eigen::AlignedBox2f extent(float margin) const;

  /// Whether it holds a point of the level frame when its sides and top are grown by `margin`.
  bool holds(const Eigen::Vector3f& point, float margin) const {
    const float dx = point.x() - x, dy = point.y() - y;
    // Without branches, as no one could foretell them.
    return static_cast<bool>((point.z() >= low) & (point.z() <= high + margin) &
                             (std::fabs(cosYaw * dx + sinYaw * dy) <= halfLength + margin) &
                             (std::fabs(cosYaw * dy - sinYaw * dx) <= halfWidth + margin));
  }
};

}  // namespace toss
