// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RowRuns.h>

#include <algorithm>

namespace toss {
namespace {

bool linkedToNext(const ObjectNode& node, const ObjectNode& next) {
  return linked(node, next, &LinkRules::Reach::horizontal, next.column - node.column);
}

RowRun startRun(const ObjectNode& node, std::int32_t index) {
  return {index, index + 1, node.column, node.column, node.range, node.range, node.reach};
}

void extend(RowRun& run, const ObjectNode& node) {
  ++run.end;
  run.lastColumn = node.column;
  run.nearest = std::min(run.nearest, node.range);
  run.farthest = std::max(run.farthest, node.range);
  run.reach.horizontal = std::max(run.reach.horizontal, node.reach.horizontal);
  run.reach.vertical = std::max(run.reach.vertical, node.reach.vertical);
  run.reach.window = std::max(run.reach.window, node.reach.window);
}

}  // namespace

void RowRuns::build(const ObjectNodes& nodes) {
  runs.clear();
  rowBegin.assign(1, 0);
  widest = 0;
  for (std::size_t row = 0; row + 1 < nodes.rowBegin.size(); ++row) {
    for (std::int32_t n = nodes.rowBegin[row]; n < nodes.rowBegin[row + 1]; ++n) {
      const std::size_t i = static_cast<std::size_t>(n);
      widest = std::max(widest, nodes[i].reach.window);
      if (n > nodes.rowBegin[row] && linkedToNext(nodes[i - 1], nodes[i])) {
        extend(runs.back(), nodes[i]);
      } else {
        runs.push_back(startRun(nodes[i], n));
      }
    }
    rowBegin.push_back(static_cast<std::int32_t>(size()));
  }
}

}  // namespace toss
