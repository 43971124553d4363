// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/RowRuns.h>

#include <algorithm>

namespace toss {
namespace {

bool linkedToNext(const ObjectNodes& nodes, std::size_t i) {
  return nodes.linked(nodes.horizontal, i, i + 1, nodes.column[i + 1] - nodes.column[i]);
}

}  // namespace

void RowRuns::build(const ObjectNodes& nodes) {
  nodeBegin.clear(), rowBegin.clear();
  nearest.clear(), farthest.clear(), horizontal.clear(), vertical.clear(), window.clear();
  widest = 0;
  rowBegin.push_back(0);
  for (std::size_t row = 0; row + 1 < nodes.rowBegin.size(); ++row) {
    for (std::int32_t n = nodes.rowBegin[row]; n < nodes.rowBegin[row + 1]; ++n) {
      const std::size_t i = static_cast<std::size_t>(n);
      if (n > nodes.rowBegin[row] && linkedToNext(nodes, i - 1)) {
        extend(nodes, n);
      } else {
        start(nodes, n);
      }
    }
    rowBegin.push_back(static_cast<std::int32_t>(size()));
  }
  nodeBegin.push_back(static_cast<std::int32_t>(nodes.size()));
}

void RowRuns::start(const ObjectNodes& nodes, std::int32_t node) {
  const std::size_t i = static_cast<std::size_t>(node);
  nodeBegin.push_back(node);
  nearest.push_back(nodes.range[i]);
  farthest.push_back(nodes.range[i]);
  horizontal.push_back(nodes.horizontal[i]);
  vertical.push_back(nodes.vertical[i]);
  window.push_back(nodes.window[i]);
  widest = std::max(widest, nodes.window[i]);
}

void RowRuns::extend(const ObjectNodes& nodes, std::int32_t node) {
  const std::size_t i = static_cast<std::size_t>(node);
  nearest.back() = std::min(nearest.back(), nodes.range[i]);
  farthest.back() = std::max(farthest.back(), nodes.range[i]);
  horizontal.back() = std::max(horizontal.back(), nodes.horizontal[i]);
  vertical.back() = std::max(vertical.back(), nodes.vertical[i]);
  window.back() = std::max(window.back(), nodes.window[i]);
  widest = std::max(widest, nodes.window[i]);
}

}  // namespace toss
