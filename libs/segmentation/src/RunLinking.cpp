// SPDX-License-Identifier: BSD-3-Clause
#include "RunLinking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::max();

}  // namespace

RunLinking::RunLinking(const ObjectNodes& nodes, const NodeReaches& reaches, const RowRuns& runs,
                       const LinkRules& rules, UnionFind& sets)
    : nodes_(nodes), reaches_(reaches), runs_(runs), rules_(rules), sets_(sets) {}

RunLinking::Span RunLinking::runsOf(int row) const {
  const std::size_t r = static_cast<std::size_t>(row);
  return {runs_.rowBegin[r], runs_.rowBegin[r + 1]};
}

RunLinking::Span RunLinking::firstOf(Span row) const {
  Span first{row.begin, row.begin};
  while (first.end < row.end && runs_.firstColumn[at(first.end)] < runs_.widest) ++first.end;
  return first;
}

RunLinking::Span RunLinking::lastOf(Span row) const {
  Span last{row.end, row.end};
  const Index end = rules_.columns - runs_.widest;
  while (last.begin > row.begin && runs_.lastColumn[at(last.begin - 1)] >= end) --last.begin;
  return last;
}

void RunLinking::linkRow(int row) {
  const Span runs = runsOf(row);
  limits_ = {reaches_.vertical.data(), runs_.reaches.vertical.data(), kUnlimited,
             rules_.surfaceDistance};
  for (int upper = row - 1; upper >= std::max(0, row - rules_.rowWindow); --upper) {
    linkBetween(runs, runsOf(upper));
    limits_.height = rules_.maxHeightGap, limits_.surface = 0.0f;
  }
  limits_ = {reaches_.horizontal.data(), runs_.reaches.horizontal.data(), kUnlimited, 0.0f};
  sets_.flatten(runs.begin, runs.end);
  linkWithin(runs);
  sets_.flatten(runsOf(std::max(0, row + 1 - rules_.rowWindow)).begin, runs.end);
}

void RunLinking::linkWithin(Span row) {
  sweep(row, row, 0, true);
  sweep(lastOf(row), firstOf(row), rules_.columns);
}

void RunLinking::linkBetween(Span row, Span upper) {
  sweep(row, upper, 0);
  sweep(lastOf(row), firstOf(upper), rules_.columns);
  sweep(firstOf(row), lastOf(upper), -rules_.columns);
}

void RunLinking::sweep(Span runs, Span others, Index shift, bool within) {
  const Index* const firstColumn = runs_.firstColumn.data();
  const Index* const lastColumn = runs_.lastColumn.data();
  const Index* const window = runs_.reaches.window.data();
  const float* const nearest = runs_.nearest.data();
  const float* const farthest = runs_.farthest.data();
  const float* const distance = limits_.ofRun;
  const Index* const parent = sets_.parents();
  const float surface = limits_.surface;
  // Runs of a row are sorted by their first and by their last column alike.
  Index from = others.begin;
  for (Index a = runs.begin; a < runs.end; ++a) {
    const Index left = firstColumn[a] - window[a] - shift;
    const Index right = lastColumn[a] + window[a] - shift;
    while (from > others.begin && lastColumn[from - 1] >= left) --from;
    while (from < others.end && lastColumn[from] < left) ++from;
    // Horizontal distance is at least the difference of the ranges. A hair more, for rounding. The
    // run's own link distance bounds that of every pair it is in.
    const float limit = 1.001f * std::max(distance[a], surface) + 1e-4f;
    const float near = nearest[a] - limit, far = farthest[a] + limit;
    Index set = parent[a];
    for (Index b = within ? a + 1 : from; b < others.end && firstColumn[b] <= right; ++b) {
      // A single branch, as no one could foretell two.
      const float gap = std::max(nearest[b] - far, near - farthest[b]);
      if ((parent[b] == set) | (gap > 0.0f)) continue;
      link(a, b, shift);
      set = sets_.find(a);
    }
  }
}

/// Unites two runs if any of their nodes are linked.
void RunLinking::link(Index a, Index b, Index shift) {
  if (sets_.find(a) == sets_.find(b) || apart(a, b) || !touches(a, b, shift)) return;
  sets_.unite(a, b);
}

bool RunLinking::apart(Index a, Index b) const {
  const Component& one = runs_.measures[at(a)];
  const Component& other = runs_.measures[at(b)];
  const float dx = std::max(std::max(one.minX - other.maxX, other.minX - one.maxX), 0.0f);
  const float dy = std::max(std::max(one.minY - other.maxY, other.minY - one.maxY), 0.0f);
  const float limit = std::max(std::min(limits_.ofRun[a], limits_.ofRun[b]), limits_.surface);
  return dx * dx + dy * dy >= limit * limit;
}

bool RunLinking::touches(Index a, Index b, Index shift) const {
  const Index* const column = nodes_.column.data();
  const Index window = std::min(runs_.reaches.window[at(a)], runs_.reaches.window[at(b)]);
  const Index first = runs_.firstColumn[at(b)] + shift - window;
  const Index last = runs_.lastColumn[at(b)] + shift + window;
  const Index endOfA = runs_.end[at(a)], endOfB = runs_.end[at(b)];
  Index low = runs_.begin[at(b)];
  for (Index p = runs_.begin[at(a)]; p < endOfA && column[p] <= last; ++p) {
    if (column[p] < first) continue;
    const Index here = column[p] - shift;
    while (low < endOfB && column[low] < here - window) ++low;
    for (Index q = low; q < endOfB && column[q] <= here + window; ++q) {
      if (linkedNodes(at(p), at(q), std::abs(here - column[q]))) return true;
    }
  }
  return false;
}

bool RunLinking::linkedNodes(std::size_t a, std::size_t b, Index columnGap) const {
  const float dx = nodes_.x[a] - nodes_.x[b], dy = nodes_.y[a] - nodes_.y[b];
  const float squared = dx * dx + dy * dy;
  const float limit = std::min(limits_.ofNode[a], limits_.ofNode[b]);
  const Index window = std::min(reaches_.window[a], reaches_.window[b]);
  if (squared < limit * limit && columnGap <= window &&
      std::abs(nodes_.z[a] - nodes_.z[b]) <= limits_.height) {
    return true;
  }
  return squared < limits_.surface * limits_.surface && columnGap <= 1 &&
         std::max(nodes_.z[a], nodes_.z[b]) <= -rules_.surfaceDepth;
}

}  // namespace toss
