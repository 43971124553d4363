// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Components.h>
#include <toss/segmentation/ObjectNodes.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// The runs of all rows: consecutive nodes of a row, each linked with the next. What TRAVEL
/// calls a node: the unit that is merged (spec section 3). Within a row they are sorted by their
/// first and by their last column alike. Struct of arrays.
struct RowRuns {
  /// First node, and one past the last, shape [runs].
  std::vector<std::int32_t> begin, end;
  /// Columns of the first and the last node, shape [runs].
  std::vector<std::int32_t> firstColumn, lastColumn;
  /// Least and greatest range of the nodes [m], shape [runs].
  std::vector<float> nearest, farthest;
  /// Lowest coordinate z of the nodes [m], shape [runs].
  std::vector<float> lowest;
  /// Widest window of the nodes [columns], shape [runs].
  std::vector<std::int32_t> window;
  /// Size and place of each run, shape [runs].
  std::vector<Component> measures;
  /// Runs of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Widest window of all [columns].
  std::int32_t widest = 0;

  std::size_t size() const { return begin.size(); }

  /// Cuts the rows of `nodes` into runs.
  void build(const ObjectNodes& nodes, const LinkRules& rules);
  /// Cuts those runs of `whole` that are `selected` (shape [whole.size()]) further, as shortened
  /// `rules` and the `windows` that go with them demand.
  void build(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules,
             const RowRuns& whole, const std::vector<std::uint8_t>& selected);

 private:
  void clear();
  /// Finds which nodes are linked with the one before them.
  void findLinks(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules);
  /// Adds the runs of the nodes first..last - 1 of a row.
  void cut(std::int32_t first, std::int32_t last);
  /// Fills all that is known of the runs.
  void measure(const ObjectNodes& nodes, const NodeWindows& windows);
  void measureRun(const ObjectNodes& nodes, const NodeWindows& windows, std::size_t run,
                  std::size_t first, std::size_t last);

  /// Whether each node is linked with the one before it, shape [nodes].
  std::vector<std::uint8_t> linked_;
};

}  // namespace toss
