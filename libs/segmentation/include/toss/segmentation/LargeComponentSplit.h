// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Components.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/NodeClustering.h>
#include <toss/segmentation/ObjectNodes.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Guard against under-segmentation (spec section 3.4): a component that is too long to be one
/// object is clustered again with shorter link distances, and falls into the parts found if two of
/// those that are large enough lie apart. Parts that are too small join the largest one, so that
/// neither a hedge nor a truck crumbles.
class LargeComponentSplit {
 public:
  /// Components longer than `extent` [m] are tried, with link distances times `factor`.
  LargeComponentSplit(float extent, float factor) : extent_(extent), factor_(factor) {}

  /// `component`: the component of each node, 0..count-1, changed in place; numbered by first node
  /// before and after. Returns the number of components after.
  std::int32_t split(const ObjectNodes& nodes, const LinkRules& rules,
                     std::vector<std::int32_t>& component, std::int32_t count);

 private:
  bool selectLarge(const ObjectNodes& nodes, const std::vector<std::int32_t>& component,
                   std::int32_t count);
  void cluster(const ObjectNodes& nodes, const LinkRules& rules,
               const std::vector<std::int32_t>& component);
  void judge(const LinkRules& rules, std::int32_t count);

  float extent_, factor_;
  NodeClustering clustering_;
  std::vector<Component> wholes_, parts_;
  std::vector<std::uint8_t> selected_;
  ObjectNodes nodes_;
  std::vector<std::int32_t> source_, partOfNode_, wholeOfPart_, scratch_;
  /// Of each whole: whether it is split, its parts that are large enough, and the largest of all.
  struct Verdict {
    bool split = false;
    std::vector<std::int32_t> parts;
    std::int32_t largest = -1;
  };
  std::vector<Verdict> verdicts_;
  /// Part that each part is counted to.
  std::vector<std::int32_t> target_;
};

}  // namespace toss
