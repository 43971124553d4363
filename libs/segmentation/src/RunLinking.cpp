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

RunLinking::Index RunLinking::firstColumn(Index run) const {
  const Index node = runs_.nodeBegin[static_cast<std::size_t>(run)];
  return nodes_.column[static_cast<std::size_t>(node)];
}

RunLinking::Index RunLinking::lastColumn(Index run) const {
  const Index node = runs_.nodeBegin[static_cast<std::size_t>(run) + 1] - 1;
  return nodes_.column[static_cast<std::size_t>(node)];
}

void RunLinking::linkWithin(int row) {
  nodeDistance_ = &nodes_.horizontal;
  runDistance_ = &runs_.horizontal;
  heightLimit_ = std::numeric_limits<float>::max();
  const Span span = runsOf(row);
  sweep(span, span, 0);
  sweepSeam(span, span);
}

void RunLinking::linkBetween(int upper, int lower) {
  nodeDistance_ = &nodes_.vertical;
  runDistance_ = &runs_.vertical;
  heightLimit_ = lower - upper > 1 ? rules_.maxHeightGap : std::numeric_limits<float>::max();
  sweep(runsOf(upper), runsOf(lower), 0);
  sweepSeam(runsOf(upper), runsOf(lower));
  sweepSeam(runsOf(lower), runsOf(upper));
}

void RunLinking::sweepSeam(Span left, Span right) {
  Span atEnd{left.end, left.end}, atStart{right.begin, right.begin};
  while (atEnd.begin > left.begin && lastColumn(atEnd.begin - 1) >= rules_.columns - runs_.widest) {
    --atEnd.begin;
  }
  while (atStart.end < right.end && firstColumn(atStart.end) < runs_.widest) ++atStart.end;
  sweep(atEnd, atStart, rules_.columns);
}

void RunLinking::sweep(Span first, Span second, Index shift) {
  Index low = second.begin;
  for (Index a = first.begin; a < first.end; ++a) {
    const Index left = firstColumn(a) - shift, right = lastColumn(a) - shift;
    while (low < second.end && lastColumn(low) < left - runs_.widest) ++low;
    for (Index b = low; b < second.end && firstColumn(b) <= right + runs_.widest; ++b) {
      if (mayTouch(a, b, shift) && sets_.find(a) != sets_.find(b) && touches(a, b, shift)) {
        sets_.unite(a, b);
      }
    }
  }
}

bool RunLinking::mayTouch(Index a, Index b, Index shift) const {
  const std::size_t i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  // Horizontal distance is at least the difference of the ranges. A hair more, for rounding.
  const float distance = 1.001f * std::min((*runDistance_)[i], (*runDistance_)[j]) + 1e-4f;
  if (runs_.nearest[i] - runs_.farthest[j] > distance) return false;
  if (runs_.nearest[j] - runs_.farthest[i] > distance) return false;
  const Index window = std::min(runs_.window[i], runs_.window[j]);
  return firstColumn(b) + shift <= lastColumn(a) + window &&
         lastColumn(b) + shift >= firstColumn(a) - window;
}

bool RunLinking::touches(Index a, Index b, Index shift) const {
  const std::size_t i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const Index window = std::min(runs_.window[i], runs_.window[j]);
  const Index left = firstColumn(b) + shift - window, right = lastColumn(b) + shift + window;
  Index low = runs_.nodeBegin[j];
  const Index end = runs_.nodeBegin[j + 1];
  for (Index p = runs_.nodeBegin[i]; p < runs_.nodeBegin[i + 1]; ++p) {
    const std::size_t node = static_cast<std::size_t>(p);
    const Index column = nodes_.column[node];
    if (column < left) continue;
    if (column > right) break;
    const auto other = [&](Index q) { return nodes_.column[static_cast<std::size_t>(q)] + shift; };
    while (low < end && other(low) < column - window) ++low;
    for (Index q = low; q < end && other(q) <= column + window; ++q) {
      if (linked(node, static_cast<std::size_t>(q), std::abs(other(q) - column))) return true;
    }
  }
  return false;
}

bool RunLinking::linked(std::size_t a, std::size_t b, Index columnGap) const {
  return nodes_.linked(*nodeDistance_, a, b, columnGap) &&
         std::abs(nodes_.z[a] - nodes_.z[b]) <= heightLimit_;
}

}  // namespace toss
