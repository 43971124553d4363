// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/NodeClustering.h>

#include "RunLinking.h"

namespace toss {

void NodeClustering::cluster(const ObjectNodes& nodes, const LinkRules& rules) {
  runs_.build(nodes, rules);
  link(nodes, nodes.windows, rules);
}

void NodeClustering::cluster(const ObjectNodes& nodes, const NodeWindows& windows,
                             const LinkRules& rules, const NodeClustering& whole,
                             const std::vector<std::uint8_t>& selected) {
  runs_.build(nodes, windows, rules, whole.runs(), selected);
  link(nodes, windows, rules);
}

void NodeClustering::link(const ObjectNodes& nodes, const NodeWindows& windows,
                          const LinkRules& rules) {
  sets_.reset(runs_.size());
  RunLinking linking(nodes, windows, runs_, rules, search_, sets_);
  for (int row = 0; row < nodes.rows(); ++row) linking.linkRow(row);
  componentOfRun_.resize(runs_.size());
  components_.clear();
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    // The representative is the smallest run of its set, so it has its number already.
    const auto root = static_cast<std::size_t>(sets_.find(static_cast<std::int32_t>(run)));
    if (root == run) {
      componentOfRun_[run] = static_cast<std::int32_t>(components_.size());
      components_.emplace_back();
    }
    componentOfRun_[run] = componentOfRun_[root];
    components_[static_cast<std::size_t>(componentOfRun_[run])].merge(runs_.runs[run].measure);
  }
}

}  // namespace toss
