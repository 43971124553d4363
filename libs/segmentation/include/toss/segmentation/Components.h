// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectNodes.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

/// What is known of one cluster of nodes.
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
};

/// Measures the components 0..count-1; `component`: that of each node.
void measureComponents(const ObjectNodes& nodes, const std::vector<std::int32_t>& component,
                       std::int32_t count, std::vector<Component>& result);

/// Renumbers `component` from 0 in order of each component's first node. Returns their number.
/// `scratch` is memory to be reused.
std::int32_t renumberByFirstNode(std::vector<std::int32_t>& component, std::int32_t count,
                                 std::vector<std::int32_t>& scratch);

}  // namespace toss
