// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/LargeComponentSplit.h>

namespace toss {
namespace {

bool anyTwoApart(const std::vector<std::int32_t>& parts, const std::vector<Component>& measures) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const Component& a = measures[static_cast<std::size_t>(parts[i])];
      if (!a.overlaps(measures[static_cast<std::size_t>(parts[j])])) return true;
    }
  }
  return false;
}

}  // namespace

std::int32_t LargeComponentSplit::split(const ObjectNodes& nodes, const LinkRules& rules,
                                        std::vector<std::int32_t>& component, std::int32_t count) {
  if (!selectLarge(nodes, component, count)) return count;
  cluster(nodes, rules, component);
  judge(rules, count);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::int32_t& c = component[static_cast<std::size_t>(source_[i])];
    if (!verdicts_[static_cast<std::size_t>(c)].split) continue;
    c = count + target_[static_cast<std::size_t>(partOfNode_[i])];
  }
  return renumberByFirstNode(component, count + static_cast<std::int32_t>(parts_.size()), scratch_);
}

bool LargeComponentSplit::selectLarge(const ObjectNodes& nodes,
                                      const std::vector<std::int32_t>& component,
                                      std::int32_t count) {
  measureComponents(nodes, component, count, wholes_);
  bool any = false;
  selected_.assign(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (wholes_[static_cast<std::size_t>(component[i])].extent() > extent_) {
      selected_[i] = 1;
      any = true;
    }
  }
  return any;
}

void LargeComponentSplit::cluster(const ObjectNodes& nodes, const LinkRules& rules,
                                  const std::vector<std::int32_t>& component) {
  selectNodes(nodes, selected_, factor_, nodes_, source_);
  LinkRules shorter = rules;
  shorter.surfaceDistance *= factor_;
  const std::int32_t parts = clustering_.cluster(nodes_, shorter, partOfNode_);
  measureComponents(nodes_, partOfNode_, parts, parts_);
  wholeOfPart_.resize(parts_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    wholeOfPart_[static_cast<std::size_t>(partOfNode_[i])] =
        component[static_cast<std::size_t>(source_[i])];
  }
}

void LargeComponentSplit::judge(const LinkRules& rules, std::int32_t count) {
  verdicts_.resize(static_cast<std::size_t>(count));
  for (Verdict& verdict : verdicts_) {
    verdict.parts.clear();
    verdict.largest = -1;
  }
  const auto returnsOf = [&](std::int32_t p) {
    return parts_[static_cast<std::size_t>(p)].returns;
  };
  target_.assign(parts_.size(), -1);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const auto part = static_cast<std::int32_t>(p);
    Verdict& verdict = verdicts_[static_cast<std::size_t>(wholeOfPart_[p])];
    const bool leads = verdict.largest < 0 || parts_[p].returns > returnsOf(verdict.largest);
    if (leads) verdict.largest = part;
    if (parts_[p].returns < rules.minPointsOfPart(parts_[p].nearest)) continue;
    verdict.parts.push_back(part);
    target_[p] = part;
  }
  for (Verdict& verdict : verdicts_) verdict.split = anyTwoApart(verdict.parts, parts_);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (target_[p] < 0) target_[p] = verdicts_[static_cast<std::size_t>(wholeOfPart_[p])].largest;
  }
}

}  // namespace toss
