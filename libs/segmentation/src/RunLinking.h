// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/UnionFind.h>

#include <cstddef>
#include <cstdint>

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
  /// Ranges [m] from the sensor.
  struct Interval {
    float low, high;
    bool meets(const RowRun& run) const { return run.nearest <= high && run.farthest >= low; }
  };
  Span runsOf(int row) const;
  /// Ranges at which nodes linked with the run can lie.
  Interval rangesInReach(const RowRun& run) const;
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  /// Links the runs of two rows; `second` lies beside `first` when moved by `shift` columns.
  void sweep(Span first, Span second, Index shift);
  /// Links the last runs of `left` with the first ones of `right`.
  void sweepSeam(Span left, Span right);
  /// Unites two runs if any of their nodes are linked.
  void link(Index a, Index b, Index shift);
  bool touches(const RowRun& a, const RowRun& b, Index shift) const;
  bool linkedNodes(const ObjectNode& a, const ObjectNode& b, Index shift) const;
  bool onOneSurface(const ObjectNode& a, const ObjectNode& b, Index columnGap) const;

  const ObjectNodes& nodes_;
  const RowRuns& runs_;
  const LinkRules& rules_;
  UnionFind& sets_;
  /// Link distance, height limit and surface distance [m] that hold for the two rows at hand.
  float LinkRules::Reach::*distance_ = nullptr;
  float heightLimit_ = 0.0f, surfaceDistance_ = 0.0f;
};

}  // namespace toss
