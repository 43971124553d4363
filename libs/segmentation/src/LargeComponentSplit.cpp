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
  selectNodes(nodes, selected_, factor_, nodes_, source_);
  const std::int32_t parts = clustering_.cluster(nodes_, rules, partOfNode_);
  measureComponents(nodes_, partOfNode_, parts, parts_);
  wholeOfPart_.resize(static_cast<std::size_t>(parts));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    wholeOfPart_[static_cast<std::size_t>(partOfNode_[i])] =
        component[static_cast<std::size_t>(source_[i])];
  }
  judge(rules, count);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::int32_t& c = component[static_cast<std::size_t>(source_[i])];
    if (accepted_[static_cast<std::size_t>(c)]) c = count + partOfNode_[i];
  }
  return renumberByFirstNode(component, count + parts, scratch_);
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

void LargeComponentSplit::judge(const LinkRules& rules, std::int32_t count) {
  partsOfWhole_.resize(static_cast<std::size_t>(count));
  for (auto& parts : partsOfWhole_) parts.clear();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p].returns < rules.minPoints(parts_[p].nearest)) continue;
    partsOfWhole_[static_cast<std::size_t>(wholeOfPart_[p])].push_back(
        static_cast<std::int32_t>(p));
  }
  accepted_.resize(static_cast<std::size_t>(count));
  for (std::size_t w = 0; w < accepted_.size(); ++w) {
    accepted_[w] = anyTwoApart(partsOfWhole_[w], parts_);
  }
}

}  // namespace toss
