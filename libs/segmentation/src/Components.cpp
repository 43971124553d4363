// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/Components.h>

namespace toss {

void measureComponents(const ObjectNodes& nodes, const std::vector<std::int32_t>& component,
                       std::int32_t count, std::vector<Component>& result) {
  result.assign(static_cast<std::size_t>(count), Component());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Component& c = result[static_cast<std::size_t>(component[i])];
    const ObjectNode& node = nodes[i];
    c.returns += node.returns;
    c.nearest = std::min(c.nearest, node.range);
    c.minX = std::min(c.minX, node.x), c.maxX = std::max(c.maxX, node.x);
    c.minY = std::min(c.minY, node.y), c.maxY = std::max(c.maxY, node.y);
  }
}

std::int32_t renumberByFirstNode(std::vector<std::int32_t>& component, std::int32_t count,
                                 std::vector<std::int32_t>& scratch) {
  scratch.assign(static_cast<std::size_t>(count), -1);
  std::int32_t next = 0;
  for (std::int32_t& c : component) {
    std::int32_t& number = scratch[static_cast<std::size_t>(c)];
    if (number < 0) number = next++;
    c = number;
  }
  return next;
}

}  // namespace toss
