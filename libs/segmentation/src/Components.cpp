// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/Components.h>

namespace toss {

void measureComponents(const ObjectNodes& nodes, const std::vector<std::int32_t>& component,
                       std::int32_t count, std::vector<Component>& result) {
  result.assign(static_cast<std::size_t>(count), Component());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Component& c = result[static_cast<std::size_t>(component[i])];
    c.returns += nodes.returns[i];
    c.nearest = std::min(c.nearest, nodes.range[i]);
    c.minX = std::min(c.minX, nodes.x[i]), c.maxX = std::max(c.maxX, nodes.x[i]);
    c.minY = std::min(c.minY, nodes.y[i]), c.maxY = std::max(c.maxY, nodes.y[i]);
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
