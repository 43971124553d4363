// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/RowRuns.h>

#include <Eigen/Core>
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

/// Takes in one node after the other, all their coordinates in one go.
Run measured(const ObjectNodes& nodes, const NodeWindows& windows, std::int32_t begin,
             std::int32_t end) {
  using Place = Eigen::Map<const Eigen::Array4f>;
  const std::size_t first = at(begin), last = at(end - 1);
  Eigen::Array4f least = Place(&nodes.places[first].x), most = least;
  std::int32_t returns = nodes.returns[first], window = windows[first];
  for (std::size_t i = first + 1; i <= last; ++i) {
    const Place place(&nodes.places[i].x);
    least = least.min(place), most = most.max(place);
    returns += nodes.returns[i];
    window = std::max(window, windows[i]);
  }
  const Component measure{returns, least[3], least[0], most[0], least[1], most[1]};
  return {begin, end, nodes.column[first], nodes.column[last], window, least[2], most[3], measure};
}

}  // namespace

void RowRuns::clear(std::size_t nodes) {
  // Room for as many runs as nodes, and for what is written beyond the last.
  if (begin_.size() < nodes + 1) begin_.resize(nodes + 1), end_.resize(nodes + 1);
  count_ = 0;
  rowBegin.assign(1, 0);
}

void RowRuns::findLinks(const ObjectNodes& nodes, const NodeWindows& windows,
                        const LinkRules& rules) {
  linked_.resize(nodes.size());
  linkNeighbours(nodes.x.data(), nodes.y.data(), nodes.range.data(), nodes.column.data(),
                 windows.data(), nodes.size(), rules.horizontal, linked_.data());
}

void RowRuns::build(const ObjectNodes& nodes, const LinkRules& rules) {
  clear(nodes.size());
  findLinks(nodes, nodes.windows, rules);
  for (std::size_t row = 0; row + 1 < nodes.rowBegin.size(); ++row) {
    cut(nodes.rowBegin[row], nodes.rowBegin[row + 1]);
    rowBegin.push_back(static_cast<std::int32_t>(count_));
  }
  measure(nodes, nodes.windows);
}

void RowRuns::build(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules,
                    const RowRuns& whole, const std::vector<std::uint8_t>& selected) {
  clear(nodes.size());
  findLinks(nodes, windows, rules);
  for (std::size_t row = 0; row + 1 < whole.rowBegin.size(); ++row) {
    for (std::int32_t run = whole.rowBegin[row]; run < whole.rowBegin[row + 1]; ++run) {
      if (selected[at(run)] != 0) cut(whole[run].begin, whole[run].end);
    }
    rowBegin.push_back(static_cast<std::int32_t>(count_));
  }
  measure(nodes, windows);
}

/// Without branches, as no one could foretell where runs end.
void RowRuns::cut(std::int32_t first, std::int32_t last) {
  if (first == last) return;
  std::size_t run = count_;
  begin_[run] = first;
  for (std::int32_t node = first + 1; node < last; ++node) {
    end_[run] = node, begin_[run + 1] = node;
    run += linked_[at(node)] == 0 ? 1 : 0;
  }
  end_[run] = last;
  count_ = run + 1;
}

void RowRuns::measure(const ObjectNodes& nodes, const NodeWindows& windows) {
  runs.resize(count_);
  widest = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    runs[run] = measured(nodes, windows, begin_[run], end_[run]);
    widest = std::max(widest, runs[run].window);
  }
}

}  // namespace toss
