// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectNodes.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Runs: consecutive nodes of a row, each linked with the next. What TRAVEL calls a node: the unit
/// that is merged (spec section 3).
struct RowRuns {
  /// Nodes of run k are nodeBegin[k] .. nodeBegin[k + 1] - 1, shape [runs + 1].
  std::vector<std::int32_t> nodeBegin;
  /// Runs of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Over the nodes of each run: least and greatest range [m], greatest link distances [m], and
  /// widest window [columns], shape [runs] each.
  std::vector<float> nearest, farthest, horizontal, vertical;
  std::vector<std::int32_t> window;
  /// Widest window of all [columns].
  std::int32_t widest = 0;

  std::size_t size() const { return nearest.size(); }

  /// Cuts the rows of `nodes` into runs.
  void build(const ObjectNodes& nodes);

 private:
  void start(const ObjectNodes& nodes, std::int32_t node);
  void extend(const ObjectNodes& nodes, std::int32_t node);
};

}  // namespace toss
