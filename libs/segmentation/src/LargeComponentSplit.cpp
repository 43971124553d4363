// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LargeComponentSplit.h>

#include <algorithm>

namespace toss {
namespace {

std::size_t at(std::int32_t index) {
  return static_cast<std::size_t>(index);
}

bool anyTwoApart(const std::vector<std::int32_t>& parts, const std::vector<Component>& measures) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (!measures[at(parts[i])].overlaps(measures[at(parts[j])])) return true;
    }
  }
  return false;
}

}  // namespace

void LargeComponentSplit::split(const ObjectNodes& nodes, const LinkRules& rules,
                                const NodeClustering& wholes, NodeComponents& result) {
  const std::size_t count = wholes.components().size();
  const bool any = selectLarge(wholes);
  // Those of earlier scans keep the memory of their lists.
  if (verdicts_.size() < count) verdicts_.resize(count);
  for (std::size_t whole = 0; whole < count; ++whole) verdicts_[whole].split = false;
  std::size_t parts = 0;
  if (any) {
    clusterAgain(nodes, rules, wholes);
    judge(rules, count);
    parts = parts_.components().size();
  }
  number_.assign(count + parts, -1);
  result.pieces.clear(), result.measures.clear();
  // Both lists of runs are in the order of the nodes, and the parts' runs divide those selected.
  std::size_t part = 0;
  for (std::size_t run = 0; run < wholes.runs().size(); ++run) {
    const std::int32_t whole = wholes.componentOfRun()[run];
    if (!verdicts_[at(whole)].split) {
      addPiece(wholes.runs(), run, whole, wholes.components()[at(whole)], result);
    }
    if (selected_[run] == 0) continue;
    for (; part < parts_.runs().size() &&
           parts_.runs().runs[part].begin < wholes.runs().runs[run].end;
         ++part) {
      if (!verdicts_[at(whole)].split) continue;
      const std::int32_t target = target_[at(parts_.componentOfRun()[part])];
      const auto component = static_cast<std::int32_t>(count) + target;
      addPiece(parts_.runs(), part, component, measureOfTarget_[at(target)], result);
    }
  }
}

void LargeComponentSplit::addPiece(const RowRuns& runs, std::size_t run, std::int32_t component,
                                   const Component& measure, NodeComponents& result) {
  std::int32_t& number = number_[at(component)];
  if (number < 0) {
    number = static_cast<std::int32_t>(result.measures.size());
    result.measures.push_back(measure);
  }
  result.pieces.push_back({runs.runs[run].begin, runs.runs[run].end, number});
}

bool LargeComponentSplit::selectLarge(const NodeClustering& wholes) {
  bool any = false;
  selected_.assign(wholes.runs().size(), 0);
  if (extent_ == 0.0f) return false;
  for (std::size_t run = 0; run < wholes.runs().size(); ++run) {
    const Component& whole = wholes.components()[at(wholes.componentOfRun()[run])];
    // Without branches, as no one could foretell them.
    const bool large = whole.extent() > extent_;
    selected_[run] = static_cast<std::uint8_t>(large);
    any |= large;
  }
  return any;
}

void LargeComponentSplit::clusterAgain(const ObjectNodes& nodes, const LinkRules& rules,
                                       const NodeClustering& wholes) {
  shortenWindows(nodes.windows, factor_, windows_);
  parts_.cluster(nodes, windows_, rules.shortened(factor_), wholes, selected_);
  wholeOfPart_.resize(parts_.components().size());
  std::size_t part = 0;
  for (std::size_t run = 0; run < wholes.runs().size(); ++run) {
    if (selected_[run] == 0) continue;
    for (; part < parts_.runs().size() &&
           parts_.runs().runs[part].begin < wholes.runs().runs[run].end;
         ++part) {
      wholeOfPart_[at(parts_.componentOfRun()[part])] = wholes.componentOfRun()[run];
    }
  }
}

void LargeComponentSplit::judge(const LinkRules& rules, std::size_t count) {
  const std::vector<Component>& parts = parts_.components();
  for (std::size_t whole = 0; whole < count; ++whole) {
    verdicts_[whole].parts.clear();
    verdicts_[whole].largest = -1;
  }
  target_.assign(parts.size(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto part = static_cast<std::int32_t>(p);
    Verdict& verdict = verdicts_[at(wholeOfPart_[p])];
    const bool leads = verdict.largest < 0 || parts[p].returns > parts[at(verdict.largest)].returns;
    if (leads) verdict.largest = part;
    if (parts[p].returns < rules.minPointsOfPart(parts[p].nearest)) continue;
    verdict.parts.push_back(part);
    target_[p] = part;
  }
  for (std::size_t whole = 0; whole < count; ++whole) {
    verdicts_[whole].split = anyTwoApart(verdicts_[whole].parts, parts);
  }
  measureOfTarget_.assign(parts.size(), Component());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (target_[p] < 0) target_[p] = verdicts_[at(wholeOfPart_[p])].largest;
    measureOfTarget_[at(target_[p])].merge(parts[p]);
  }
}

}  // namespace toss
