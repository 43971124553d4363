// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace toss {

/// What is known of a set of nodes: a run or a cluster.
struct Component {
  /// Returns of all its nodes.
  std::int32_t returns = 0;
  /// Horizontal distance from the sensor to its nearest node [m].
  float nearest = std::numeric_limits<float>::max();
  /// Extent in the level frame [m].
  float minX = std::numeric_limits<float>::max(), maxX = std::numeric_limits<float>::lowest();
  float minY = std::numeric_limits<float>::max(), maxY = std::numeric_limits<float>::lowest();

  /// Longer horizontal side [m].
  float extent() const { return std::max(maxX - minX, maxY - minY); }
  bool overlaps(const Component& other) const {
    return minX <= other.maxX && other.minX <= maxX && minY <= other.maxY && other.minY <= maxY;
  }
  /// Takes in the nodes of another.
  void merge(const Component& other) {
    returns += other.returns;
    nearest = std::min(nearest, other.nearest);
    minX = std::min(minX, other.minX), maxX = std::max(maxX, other.maxX);
    minY = std::min(minY, other.minY), maxY = std::max(maxY, other.maxY);
  }
};

}  // namespace toss
