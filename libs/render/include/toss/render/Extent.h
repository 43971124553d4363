// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <Eigen/Core>
#include <array>
#include <vector>

namespace toss {

/// A box along the axes of the map [m].
struct Extent {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();

  Eigen::Vector3d center() const { return 0.5 * (low + high); }
  Eigen::Vector3d size() const { return high - low; }
  void include(const Eigen::Vector3d& point);
  bool contains(const Eigen::Vector3d& point) const;
  /// The eight corners.
  std::array<Eigen::Vector3d, 8> corners() const;
};

/// The smallest box around the points, and zeros for none.
Extent fullExtent(const std::vector<MapPoint>& points);

/// The box that shows the map: 0.2 % to 99.8 % quantiles of each coordinate, grown by a fiftieth
/// of its size on each side and never beyond fullExtent(). A few returns far out do not shrink the
/// picture; a map without any is shown to its corners.
Extent robustExtent(const std::vector<MapPoint>& points);

/// Corners of small boxes that together hold every point of the map within `extent` [m]: what a
/// camera has to show, far fewer than the points.
std::vector<Eigen::Vector3d> outlineOf(const std::vector<MapPoint>& points, const Extent& extent);

/// Two values of a quantity, lower one first.
struct ValueRange {
  float low = 0.0f, high = 1.0f;

  /// 0 at low, 1 at high, clamped.
  float position(float value) const;
};

/// 2 % and 98 % quantiles of the height [m] or the intensity: what colour ramps span. Widened where
/// they fall together.
ValueRange heightRange(const std::vector<MapPoint>& points);
ValueRange intensityRange(const std::vector<MapPoint>& points);

}  // namespace toss
