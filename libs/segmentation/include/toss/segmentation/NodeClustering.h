// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Components.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RowRuns.h>
#include <toss/segmentation/RunSearch.h>
#include <toss/segmentation/UnionFind.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Connected components of the links of LinkRules, exact: every linked pair of nodes ends up in one
/// component, whatever the order (spec section 3.3). Runs only save looking at pairs that are
/// joined already or too far apart.
class NodeClustering {
 public:
  /// Clusters all nodes.
  void cluster(const ObjectNodes& nodes, const LinkRules& rules);
  /// Clusters the nodes of those runs of `whole` that are `selected` (shape [whole.runs().size()])
  /// by shortened `rules` and the `windows` that go with them.
  void cluster(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules,
               const NodeClustering& whole, const std::vector<std::uint8_t>& selected);

  const RowRuns& runs() const { return runs_; }
  /// Component of each run, numbered from 0 by first node, shape [runs().size()].
  const std::vector<std::int32_t>& componentOfRun() const { return componentOfRun_; }
  /// Size and place of each component.
  const std::vector<Component>& components() const { return components_; }

 private:
  void link(const ObjectNodes& nodes, const NodeWindows& windows, const LinkRules& rules);

  RowRuns runs_;
  RunSearch search_;
  UnionFind sets_;
  std::vector<std::int32_t> componentOfRun_;
  std::vector<Component> components_;
};

}  // namespace toss
