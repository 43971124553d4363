// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectNodes.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Consecutive nodes of a row, each linked with the next. What TRAVEL calls a node: the unit that
/// is merged (spec section 3).
struct RowRun {
  /// First node, and one past the last.
  std::int32_t begin, end;
  /// Columns of the first and the last node.
  std::int32_t firstColumn, lastColumn;
  /// Least and greatest range of the nodes [m].
  float nearest, farthest;
  /// Greatest reach of the nodes.
  LinkRules::Reach reach;
};

/// The runs of all rows. Within a row they are sorted by their first and by their last column
/// alike.
struct RowRuns {
  std::vector<RowRun> runs;
  /// Runs of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Widest window of all [columns].
  std::int32_t widest = 0;

  std::size_t size() const { return runs.size(); }
  const RowRun& operator[](std::size_t i) const { return runs[i]; }

  /// Cuts the rows of `nodes` into runs.
  void build(const ObjectNodes& nodes);
};

}  // namespace toss
