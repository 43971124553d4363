// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/RowRuns.h>

#include <algorithm>

namespace toss {
namespace {

std::size_t at(std::int32_t index) {
  return static_cast<std::size_t>(index);
}

// The compiler vectorises this only as a function of arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void linkNeighbours(const float* __restrict x, const float* __restrict y,
                    const float* __restrict range, const std::int32_t* __restrict column,
                    const std::int32_t* __restrict window, std::size_t n,
                    const LinkRules::Distance& distance, std::uint8_t* __restrict linked) {
  const LinkRules::Distance held = distance;
  for (std::size_t i = 1; i < n; ++i) {
    const float dx = x[i] - x[i - 1], dy = y[i] - y[i - 1];
    const float limit = held.at(std::min(range[i], range[i - 1]));
    const std::int32_t columns = std::min(window[i], window[i - 1]);
    const bool near = dx * dx + dy * dy < limit * limit;
    linked[i] = static_cast<std::uint8_t>(near & (column[i] - column[i - 1] <= columns));
  }
}

}  // namespace

void RowRuns::clear() {
  begin.clear(), end.clear();
  rowBegin.assign(1, 0);
}

void RowRuns::findLinks(const ObjectNodes& nodes, const NodeWindows& windows,
                        const LinkRules& rules) {
  linked_.resize(nodes.size());
  linkNeighbours(nodes.x.data(), nodes.y.data(), nodes.range.data(), nodes.column.data(),
                 windows.data(), nodes.size(), rules.horizontal, linked_.data());
}

void RowRuns::build(const ObjectNodes& nodes, const LinkRules& rules) {
  clear();
  findLinks(nodes, nodes.windows, rules);
  for (std::size_t row = 0; row + 1 < nodes.rowBegin.size(); ++row) {
    cut(nodes.rowBegin[row], nodes.rowBegin[row + 1]);
    rowBegin.push_back(static_cast<std::int32_t>(size()));
  }
  measure(nodes, nodes.windows);
}

void RowRuns::build(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules,
                    const RowRuns& whole, const std::vector<std::uint8_t>& selected) {
  clear();
  findLinks(nodes, windows, rules);
  for (std::size_t row = 0; row + 1 < whole.rowBegin.size(); ++row) {
    for (std::int32_t run = whole.rowBegin[row]; run < whole.rowBegin[row + 1]; ++run) {
      if (selected[at(run)] != 0) cut(whole.begin[at(run)], whole.end[at(run)]);
    }
    rowBegin.push_back(static_cast<std::int32_t>(size()));
  }
  measure(nodes, windows);
}

/// Without branches, as no one could foretell where runs end.
void RowRuns::cut(std::int32_t first, std::int32_t last) {
  if (first == last) return;
  const std::size_t before = begin.size();
  const auto most = before + static_cast<std::size_t>(last - first);
  begin.resize(most), end.resize(most);
  begin[before] = first;
  std::size_t run = before;
  for (std::int32_t node = first + 1; node < last; ++node) {
    end[run] = node, begin[run + 1] = node;
    run += linked_[at(node)] == 0 ? 1 : 0;
  }
  end[run] = last;
  begin.resize(run + 1), end.resize(run + 1);
}

void RowRuns::measure(const ObjectNodes& nodes, const NodeWindows& windows) {
  const std::size_t n = size();
  firstColumn.resize(n), lastColumn.resize(n);
  nearest.resize(n), farthest.resize(n), lowest.resize(n), measures.resize(n), window.resize(n);
  widest = 0;
  for (std::size_t run = 0; run < n; ++run) {
    const std::size_t first = at(begin[run]), last = at(end[run]);
    firstColumn[run] = nodes.column[first], lastColumn[run] = nodes.column[last - 1];
    measureRun(nodes, windows, run, first, last);
    widest = std::max(widest, window[run]);
  }
}

void RowRuns::measureRun(const ObjectNodes& nodes, const NodeWindows& windows, std::size_t run,
                         std::size_t first, std::size_t last) {
  const auto ofNode = [&](std::size_t i) {
    return Component{nodes.returns[i], nodes.range[i], nodes.x[i],
                     nodes.x[i],       nodes.y[i],     nodes.y[i]};
  };
  Component whole = ofNode(first);
  float low = nodes.z[first], far = nodes.range[first];
  std::int32_t columns = windows[first];
  for (std::size_t i = first + 1; i < last; ++i) {
    whole.merge(ofNode(i));
    low = std::min(low, nodes.z[i]);
    far = std::max(far, nodes.range[i]);
    columns = std::max(columns, windows[i]);
  }
  nearest[run] = whole.nearest, farthest[run] = far, lowest[run] = low, window[run] = columns;
  measures[run] = whole;
}

}  // namespace toss
