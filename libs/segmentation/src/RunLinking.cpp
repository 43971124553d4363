// SPDX-License-Identifier: BSD-3-Clause
#include "RunLinking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {

RunLinking::RunLinking(const ObjectNodes& nodes, const RowRuns& runs, const LinkRules& rules,
                       UnionFind& sets)
    : nodes_(nodes), runs_(runs), rules_(rules), sets_(sets) {}

RunLinking::Span RunLinking::runsOf(int row) const {
  const std::size_t r = static_cast<std::size_t>(row);
  return {runs_.rowBegin[r], runs_.rowBegin[r + 1]};
}

void RunLinking::linkWithin(int row) {
  distance_ = &LinkRules::Reach::horizontal;
  heightLimit_ = std::numeric_limits<float>::max();
  surfaceDistance_ = 0.0f;
  const Span span = runsOf(row);
  for (Index a = span.begin; a < span.end; ++a) {
    const Index last = runs_[at(a)].lastColumn + runs_[at(a)].reach.window;
    const Interval ranges = rangesInReach(runs_[at(a)]);
    for (Index b = a + 1; b < span.end && runs_[at(b)].firstColumn <= last; ++b) {
      if (ranges.meets(runs_[at(b)])) link(a, b, 0);
    }
  }
  sweepSeam(span, span);
}

void RunLinking::linkBetween(int upper, int lower) {
  distance_ = &LinkRules::Reach::vertical;
  const bool neighbours = lower - upper == 1;
  heightLimit_ = neighbours ? std::numeric_limits<float>::max() : rules_.maxHeightGap;
  surfaceDistance_ = neighbours ? rules_.surfaceDistance : 0.0f;
  sweep(runsOf(upper), runsOf(lower), 0);
  sweepSeam(runsOf(upper), runsOf(lower));
  sweepSeam(runsOf(lower), runsOf(upper));
}

void RunLinking::sweepSeam(Span left, Span right) {
  Span atEnd{left.end, left.end}, atStart{right.begin, right.begin};
  const Index end = rules_.columns - runs_.widest;
  while (atEnd.begin > left.begin && runs_[at(atEnd.begin - 1)].lastColumn >= end) --atEnd.begin;
  while (atStart.end < right.end && runs_[at(atStart.end)].firstColumn < runs_.widest) {
    ++atStart.end;
  }
  sweep(atEnd, atStart, rules_.columns);
}

void RunLinking::sweep(Span first, Span second, Index shift) {
  // Runs of a row are sorted by their first and by their last column alike.
  Index beside = second.begin;
  for (Index a = first.begin; a < first.end; ++a) {
    const Index left = runs_[at(a)].firstColumn - shift, right = runs_[at(a)].lastColumn - shift;
    const Index window = runs_[at(a)].reach.window;
    const Interval ranges = rangesInReach(runs_[at(a)]);
    while (beside < second.end && runs_[at(beside)].lastColumn < left) ++beside;
    for (Index b = beside; b < second.end && runs_[at(b)].firstColumn <= right + window; ++b) {
      if (ranges.meets(runs_[at(b)])) link(a, b, shift);
    }
    for (Index b = beside; b > second.begin && runs_[at(b - 1)].lastColumn >= left - window; --b) {
      if (ranges.meets(runs_[at(b - 1)])) link(a, b - 1, shift);
    }
  }
}

RunLinking::Interval RunLinking::rangesInReach(const RowRun& run) const {
  // Horizontal distance is at least the difference of the ranges. A hair more, for rounding. The
  // run's own link distance bounds that of every pair it is in.
  const float limit = 1.001f * std::max(run.reach.*distance_, surfaceDistance_) + 1e-4f;
  return {run.nearest - limit, run.farthest + limit};
}

void RunLinking::link(Index a, Index b, Index shift) {
  if (sets_.find(a) == sets_.find(b)) return;
  if (touches(runs_[at(a)], runs_[at(b)], shift)) sets_.unite(a, b);
}

bool RunLinking::touches(const RowRun& a, const RowRun& b, Index shift) const {
  const Index window = std::min(a.reach.window, b.reach.window);
  Index low = b.begin;
  for (Index p = a.begin; p < a.end; ++p) {
    const ObjectNode& node = nodes_[at(p)];
    const Index column = node.column - shift;
    if (column < b.firstColumn - window) continue;
    if (column > b.lastColumn + window) break;
    while (low < b.end && nodes_[at(low)].column < column - window) ++low;
    for (Index q = low; q < b.end && nodes_[at(q)].column <= column + window; ++q) {
      if (linkedNodes(node, nodes_[at(q)], shift)) return true;
    }
  }
  return false;
}

bool RunLinking::linkedNodes(const ObjectNode& a, const ObjectNode& b, Index shift) const {
  const Index columnGap = std::abs(a.column - shift - b.column);
  return (linked(a, b, distance_, columnGap) && std::abs(a.z - b.z) <= heightLimit_) ||
         onOneSurface(a, b, columnGap);
}

bool RunLinking::onOneSurface(const ObjectNode& a, const ObjectNode& b, Index columnGap) const {
  if (columnGap > 1 || std::max(a.z, b.z) > -rules_.surfaceDepth) return false;
  const float dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy < surfaceDistance_ * surfaceDistance_;
}

}  // namespace toss
