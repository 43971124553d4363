// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/NodeClustering.h>

#include <algorithm>

#include "RunLinking.h"

namespace toss {

std::int32_t NodeClustering::cluster(const ObjectNodes& nodes, const LinkRules& rules,
                                     std::vector<std::int32_t>& component) {
  runs_.build(nodes);
  sets_.reset(runs_.size());
  RunLinking linking(nodes, runs_, rules, sets_);
  for (int row = 0; row < nodes.rows(); ++row) {
    linking.linkWithin(row);
    for (int upper = row - 1; upper >= std::max(0, row - rules.rowWindow); --upper) {
      linking.linkBetween(upper, row);
    }
  }
  number_.resize(runs_.size());
  component.resize(nodes.size());
  std::int32_t count = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    // The representative is the smallest run of its set, so it has its number already.
    const std::int32_t root = sets_.find(static_cast<std::int32_t>(run));
    number_[run] =
        root == static_cast<std::int32_t>(run) ? count++ : number_[static_cast<std::size_t>(root)];
    std::fill(component.begin() + runs_[run].begin, component.begin() + runs_[run].end,
              number_[run]);
  }
  return count;
}

}  // namespace toss
