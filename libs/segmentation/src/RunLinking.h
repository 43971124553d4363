// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/RunSearch.h>
#include <toss/segmentation/UnionFind.h>

#include <cstddef>
#include <cstdint>

namespace toss {

/// Unites the runs of which any two nodes are linked. Within a row that covers TRAVEL's skip-merge
/// and ring closure, between rows its vertical merge, both also across the rear seam.
class RunLinking {
 public:
  /// `windows`: those of the nodes by which `runs` were cut; `search`: buffers. All references must
  /// outlive this.
  RunLinking(const ObjectNodes& nodes, const NodeWindows& windows, const RowRuns& runs,
             const LinkRules& rules, RunSearch& search, UnionFind& sets);

  /// Unites the runs of `row` with each other and with those of the rows above that links reach.
  void linkRow(int row);

 private:
  using Index = std::int32_t;
  using Span = RunColumns::Span;
  /// What holds for links of two rows: link distance, limit of the height difference [m] and
  /// surface distance [m].
  struct Limits {
    LinkRules::Distance distance;
    float height, surface;
  };
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  static Index nodesOf(const Run& run) { return run.end - run.begin; }
  Span runsOf(int row) const;
  /// The first and the last runs of a row, which may lie in reach of each other across the seam.
  Span firstOf(int row) const;
  Span lastOf(int row) const;
  /// Tells the search of which sets runs are.
  void noteSets(Span runs);
  /// Links runs of `row` with those of the rows above and of the same row, as these lie when moved
  /// by `shift` columns to the right.
  void linkUpwards(Span runs, int row, Index shift);
  void linkWithin(Span runs, int row, Index shift);
  template <bool withSurface>
  void linkNear(Index a, Index& root, Span others, RunVicinity& vicinity, const Limits& limits,
                Index shift);
  bool link(Index a, Index& root, Index b, const Limits& limits, Index shift);
  bool touchMidway(const Run& a, const Run& b, const Limits& limits, Index shift) const;
  /// Whether the rectangles around two runs are too far apart for any of their nodes to be linked.
  static bool apart(const Run& a, const Run& b, const Limits& limits);
  bool touches(const Run& a, const Run& b, const Limits& limits, Index shift) const;
  Index firstFrom(Index begin, Index end, Index column) const;
  bool linkedNodes(std::size_t a, std::size_t b, const Limits& limits, Index columnGap) const;

  const ObjectNodes& nodes_;
  const NodeWindows& windows_;
  const RowRuns& runs_;
  const LinkRules& rules_;
  RunSearch& search_;
  UnionFind& sets_;
  Limits within_, nextRow_, fartherRow_;
};

}  // namespace toss
