// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/UnionFind.h>

#include <vector>

namespace toss {

/// Unites the runs of which any two nodes are linked. Within a row that covers TRAVEL's skip-merge
/// and ring closure, between rows its vertical merge, both also across the rear seam.
class RunLinking {
 public:
  RunLinking(const ObjectNodes& nodes, const RowRuns& runs, const LinkRules& rules,
             UnionFind& sets);

  /// Unites the runs of `row` with each other.
  void linkWithin(int row);
  /// Unites the runs of `upper` with those of `lower`, a row below it.
  void linkBetween(int upper, int lower);

 private:
  using Index = std::int32_t;
  /// Consecutive runs of a row.
  struct Span {
    Index begin, end;
  };
  Span runsOf(int row) const;
  Index firstColumn(Index run) const;
  Index lastColumn(Index run) const;
  /// Where `second` is moved by `shift` columns to lie beside `first` across the seam.
  void sweep(Span first, Span second, Index shift);
  void sweepSeam(Span left, Span right);
  bool mayTouch(Index a, Index b, Index shift) const;
  bool touches(Index a, Index b, Index shift) const;
  bool linked(std::size_t a, std::size_t b, Index columnGap) const;

  const ObjectNodes& nodes_;
  const RowRuns& runs_;
  const LinkRules& rules_;
  UnionFind& sets_;
  /// Link distances that hold for the two rows at hand: per node, per run; and the height limit.
  const std::vector<float>*nodeDistance_ = nullptr, *runDistance_ = nullptr;
  float heightLimit_ = 0.0f;
};

}  // namespace toss
