// SPDX-License-Identifier: BSD-3-Clause
#include "RunLinking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr float kUnlimited = std::numeric_limits<float>::max();
/// Nodes up to which a run is walked along rather than searched.
constexpr std::int32_t kShort = 16;

/// Node of a run that lies in a column or, as some columns have none, a little right of it.
std::size_t nodeNear(const Run& run, std::int32_t column) {
  const std::int32_t place = run.begin + column - run.firstColumn;
  return static_cast<std::size_t>(std::max(run.begin, std::min(place, run.end - 1)));
}

}  // namespace

RunLinking::RunLinking(const ObjectNodes& nodes, const NodeWindows& windows, const RowRuns& runs,
                       const LinkRules& rules, RunSearch& search, UnionFind& sets)
    : nodes_(nodes),
      windows_(windows),
      runs_(runs),
      rules_(rules),
      search_(search),
      sets_(sets),
      within_{rules.horizontal, kUnlimited, 0.0f},
      nextRow_{rules.vertical, kUnlimited, rules.surfaceDistance},
      fartherRow_{rules.vertical, rules.maxHeightGap, 0.0f} {
  search_.columns.build(runs, rules.columns);
  search_.keys.build(runs);
}

RunLinking::Span RunLinking::runsOf(int row) const {
  const std::size_t r = static_cast<std::size_t>(row);
  return {runs_.rowBegin[r], runs_.rowBegin[r + 1]};
}

RunLinking::Span RunLinking::firstOf(int row) const {
  const Span all = runsOf(row);
  Span first{all.begin, all.begin};
  while (first.end < all.end && runs_[first.end].firstColumn < runs_.widest) ++first.end;
  return first;
}

RunLinking::Span RunLinking::lastOf(int row) const {
  const Span all = runsOf(row);
  Span last{all.end, all.end};
  const Index end = rules_.columns - runs_.widest;
  while (last.begin > all.begin && runs_[last.begin - 1].lastColumn >= end) --last.begin;
  return last;
}

void RunLinking::linkRow(int row) {
  linkUpwards(runsOf(row), row, 0);
  linkUpwards(lastOf(row), row, rules_.columns);
  linkUpwards(firstOf(row), row, -rules_.columns);
  linkWithin(runsOf(row), row, 0);
  linkWithin(lastOf(row), row, rules_.columns);
  noteSets({runsOf(std::max(0, row + 1 - rules_.rowWindow)).begin, runsOf(row).end});
}

void RunLinking::noteSets(Span runs) {
  for (Index run = runs.begin; run < runs.end; ++run) {
    search_.keys.setSet(run, sets_.ancestor(run));
  }
}

void RunLinking::linkUpwards(Span runs, int row, Index shift) {
  for (Index a = runs.begin; a < runs.end; ++a) {
    const Run& run = runs_[a];
    const Index first = run.firstColumn - shift, last = run.lastColumn - shift;
    const float nearest = run.measure.nearest, farthest = run.farthest;
    const RunColumns::Steps columns =
        search_.columns.stepsOf(first - run.window, last + run.window);
    Index root = sets_.find(a);
    RunVicinity vicinity;
    RunKeys::setOwnSet(root, vicinity);
    RunKeys::setRanges(nearest, farthest, rules_.vertical, vicinity);
    int upper = row - 1;
    const bool surface =
        run.lowest <= -rules_.surfaceDepth && nextRow_.distance.at(farthest) < nextRow_.surface;
    if (surface && upper >= 0) {
      RunKeys::setSurface(nearest, farthest, rules_.surfaceDistance, first, last, vicinity);
      linkNear<true>(a, root, search_.columns.touching(upper, columns), vicinity, nextRow_, shift);
      --upper;
    }
    for (; upper >= std::max(0, row - rules_.rowWindow); --upper) {
      linkNear<false>(a, root, search_.columns.touching(upper, columns), vicinity,
                      upper == row - 1 ? nextRow_ : fartherRow_, shift);
    }
    search_.keys.setSet(a, root);
  }
}

void RunLinking::linkWithin(Span runs, int row, Index shift) {
  for (Index a = runs.begin; a < runs.end; ++a) {
    const Run& run = runs_[a];
    const Index first = run.firstColumn - shift, last = run.lastColumn - shift;
    Span others = search_.columns.touching(
        row, search_.columns.stepsOf(first - run.window, last + run.window));
    if (shift == 0) others.begin = a + 1;
    Index root = sets_.find(a);
    RunVicinity vicinity;
    RunKeys::setOwnSet(root, vicinity);
    RunKeys::setRanges(run.measure.nearest, run.farthest, rules_.horizontal, vicinity);
    linkNear<false>(a, root, others, vicinity, within_, shift);
  }
}

/// Links a run, of the set of `root`, with those of others that lie in its vicinity.
template <bool withSurface>
[[gnu::always_inline]] inline void RunLinking::linkNear(Index a, Index& root, Span others,
                                                        RunVicinity& vicinity, const Limits& limits,
                                                        Index shift) {
  constexpr Index kLanes = RunKeys::kLanes;
  for (Index b = others.begin; b < others.end; b += kLanes) {
    std::uint32_t candidates = search_.keys.inVicinity<withSurface>(b, vicinity) &
                               ((1u << std::min(others.end - b, kLanes)) - 1u);
    while (candidates != 0) {
      const int lane = __builtin_ctz(candidates);
      candidates &= candidates - 1;
      if (!link(a, root, b + lane, limits, shift)) continue;
      // Many of the others have become of its set.
      RunKeys::setOwnSet(root, vicinity);
      candidates &= search_.keys.inVicinity<withSurface>(b, vicinity);
    }
  }
}

/// Unites two runs if any of their nodes are linked. Returns whether it did; `root` is then that of
/// both.
bool RunLinking::link(Index a, Index& root, Index b, const Limits& limits, Index shift) {
  const Index rootOfB = sets_.find(b);
  if (root == rootOfB) return false;
  const Run &one = runs_[a], &other = runs_[b];
  const bool linked = touchMidway(one, other, limits, shift) ||
                      (nodesOf(one) + nodesOf(other) > 2 && !apart(one, other, limits) &&
                       touches(one, other, limits, shift));
  if (linked) {
    sets_.uniteRoots(root, rootOfB);
    root = std::min(root, rootOfB);
  }
  return linked;
}

/// Whether nodes midway of the columns that two runs share are linked, as they are where surfaces
/// go on from row to row: this spares most of the searches.
bool RunLinking::touchMidway(const Run& a, const Run& b, const Limits& limits, Index shift) const {
  const Index left = std::max(a.firstColumn, b.firstColumn + shift);
  const Index right = std::min(a.lastColumn, b.lastColumn + shift);
  const Index column = (left + right) / 2;
  const std::size_t p = nodeNear(a, column), q = nodeNear(b, column - shift);
  return linkedNodes(p, q, limits, std::abs(nodes_.column[p] - shift - nodes_.column[q]));
}

bool RunLinking::apart(const Run& a, const Run& b, const Limits& limits) {
  const Component &one = a.measure, &other = b.measure;
  const float dx = std::max(std::max(one.minX - other.maxX, other.minX - one.maxX), 0.0f);
  const float dy = std::max(std::max(one.minY - other.maxY, other.minY - one.maxY), 0.0f);
  const float longest = limits.distance.at(std::min(a.farthest, b.farthest));
  const float limit = std::max(longest, limits.surface);
  return dx * dx + dy * dy >= limit * limit;
}

bool RunLinking::touches(const Run& a, const Run& b, const Limits& limits, Index shift) const {
  const Index* const column = nodes_.column.data();
  const Index window = std::min(a.window, b.window);
  const Index last = b.lastColumn + shift + window;
  // Runs are mostly short: only in long ones is the first node in reach searched for.
  const Index first = b.firstColumn + shift - window;
  Index p = a.begin, low = b.begin;
  if (a.end - p > kShort) p = firstFrom(p, a.end, first);
  while (p < a.end && column[p] < first) ++p;
  if (p < a.end && b.end - low > kShort) low = firstFrom(low, b.end, column[p] - shift - window);
  for (; p < a.end && column[p] <= last; ++p) {
    const Index here = column[p] - shift;
    while (low < b.end && column[low] < here - window) ++low;
    for (Index q = low; q < b.end && column[q] <= here + window; ++q) {
      if (linkedNodes(at(p), at(q), limits, std::abs(here - column[q]))) return true;
    }
  }
  return false;
}

/// First of consecutive nodes that lies in a column or right of it.
RunLinking::Index RunLinking::firstFrom(Index begin, Index end, Index column) const {
  const Index* const columns = nodes_.column.data();
  return static_cast<Index>(std::lower_bound(columns + begin, columns + end, column) - columns);
}

bool RunLinking::linkedNodes(std::size_t a, std::size_t b, const Limits& limits,
                             Index columnGap) const {
  const ObjectNodes::Place &one = nodes_.places[a], &other = nodes_.places[b];
  const float dx = one.x - other.x, dy = one.y - other.y;
  const float squared = dx * dx + dy * dy;
  const float limit = limits.distance.at(std::min(one.range, other.range));
  const Index window = std::min(windows_[a], windows_[b]);
  // Without branches, as no one could foretell them.
  const bool near = (squared < limit * limit) & (columnGap <= window) &
                    (std::abs(one.z - other.z) <= limits.height);
  const bool ofOneSurface = (squared < limits.surface * limits.surface) & (columnGap <= 1) &
                            (std::max(one.z, other.z) <= -rules_.surfaceDepth);
  return near | ofOneSurface;
}

}  // namespace toss
