// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Components.h>
#include <toss/segmentation/ObjectNodes.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Consecutive nodes of a row, each linked with the next. What TRAVEL calls a node: the unit that
/// is merged (spec section 3).
struct Run {
  /// First node, and one past the last.
  std::int32_t begin, end;
  /// Columns of the first and the last node.
  std::int32_t firstColumn, lastColumn;
  /// Widest window of the nodes [columns].
  std::int32_t window;
  /// Lowest coordinate z and greatest range of the nodes [m].
  float lowest, farthest;
  /// Size and place.
  Component measure;
};

/// The runs of all rows. Within a row they are sorted by their first and by their last column
/// alike.
struct RowRuns {
  std::vector<Run> runs;
  /// Runs of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Widest window of all [columns].
  std::int32_t widest = 0;

  std::size_t size() const { return runs.size(); }
  const Run& operator[](std::int32_t run) const { return runs[static_cast<std::size_t>(run)]; }

  /// Cuts the rows of `nodes` into runs.
  void build(const ObjectNodes& nodes, const LinkRules& rules);
  /// Cuts those runs of `whole` that are `selected` (shape [whole.size()]) further, as shortened
  /// `rules` and the `windows` that go with them demand.
  void build(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules,
             const RowRuns& whole, const std::vector<std::uint8_t>& selected);

 private:
  void clear(std::size_t nodes);
  /// Finds which nodes are linked with the one before them.
  void findLinks(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules);
  /// Adds the runs of the nodes first..last - 1 of a row.
  void cut(std::int32_t first, std::int32_t last);
  /// Fills `runs` with those that were cut.
  void measure(const ObjectNodes& nodes, const NodeWindows& windows);

  /// Whether each node is linked with the one before it, shape [nodes].
  std::vector<std::uint8_t> linked_;
  /// First node, and one past the last, of each run that was cut, and how many there are.
  std::vector<std::int32_t> begin_, end_;
  std::size_t count_ = 0;
};

}  // namespace toss
