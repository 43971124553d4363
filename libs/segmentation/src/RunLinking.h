// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/UnionFind.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// Unites the runs of which any two nodes are linked. Within a row that covers TRAVEL's skip-merge
/// and ring closure, between rows its vertical merge, both also across the rear seam.
class RunLinking {
 public:
  /// `reaches`: those of the nodes by which `runs` were cut. All references must outlive this.
  RunLinking(const ObjectNodes& nodes, const NodeReaches& reaches, const RowRuns& runs,
             const LinkRules& rules, UnionFind& sets);

  /// Unites the runs of `row` with each other and with those of the rows above that links reach.
  void linkRow(int row);

 private:
  using Index = std::int32_t;
  /// Consecutive runs of a row.
  struct Span {
    Index begin, end;
  };
  /// What holds for the two rows at hand: link distances of nodes and of runs [m], limit of the
  /// height difference [m] and surface distance [m].
  struct Limits {
    const float *ofNode, *ofRun;
    float height, surface;
  };
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  Span runsOf(int row) const;
  /// The first and the last runs of a row, which may lie in reach of each other across the seam.
  Span firstOf(Span row) const;
  Span lastOf(Span row) const;
  void linkWithin(Span row);
  void linkBetween(Span row, Span upper);
  /// Links runs with others, as these lie when moved by `shift` columns to the right. Of the same
  /// row (`within`), each pair is looked at once.
  void sweep(Span runs, Span others, Index shift, bool within = false);
  void link(Index a, Index b, Index shift);
  /// Whether the rectangles around two runs are too far apart for any of their nodes to be linked.
  bool apart(Index a, Index b) const;
  bool touches(Index a, Index b, Index shift) const;
  bool linkedNodes(std::size_t a, std::size_t b, Index columnGap) const;

  const ObjectNodes& nodes_;
  const NodeReaches& reaches_;
  const RowRuns& runs_;
  const LinkRules& rules_;
  UnionFind& sets_;
  Limits limits_ = {};
};

}  // namespace toss
