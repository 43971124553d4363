// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/UnionFind.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Connected components of the links of LinkRules, exact: every linked pair of nodes ends up in one
/// component, whatever the order (spec section 3.3). Runs only save looking at pairs that are
/// joined already or too far apart.
class NodeClustering {
 public:
  /// Fills `component` with the component of each node, numbered from 0 by first node, shape
  /// [nodes]. Returns the number of components.
  std::int32_t cluster(const ObjectNodes& nodes, const LinkRules& rules,
                       std::vector<std::int32_t>& component);

 private:
  RowRuns runs_;
  UnionFind sets_;
  std::vector<std::int32_t> number_;
};

}  // namespace toss
