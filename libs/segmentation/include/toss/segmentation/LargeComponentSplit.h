// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Components.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/NodeClustering.h>
#include <toss/segmentation/ObjectNodes.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Clusters of nodes.
struct NodeComponents {
  /// Consecutive nodes begin .. end - 1 of one component; they are numbered from 0 by first node.
  struct Piece {
    std::int32_t begin, end, component;
  };
  /// All nodes, in their order.
  std::vector<Piece> pieces;
  /// Size and place of each component.
  std::vector<Component> measures;
};

/// Guard against under-segmentation (spec section 3.4): a component that is too long to be one
/// object is clustered again with shorter link distances, and falls into the parts found if two of
/// those that are large enough lie apart. Parts that are too small join the largest one, so that
/// neither a hedge nor a truck crumbles.
class LargeComponentSplit {
 public:
  /// Components longer than `extent` [m] are tried, with link distances times `factor`; none for an
  /// extent of 0.
  LargeComponentSplit(float extent, float factor) : extent_(extent), factor_(factor) {}

  /// Fills `result` with the components of `wholes`, split where they are too long.
  void split(const ObjectNodes& nodes, const LinkRules& rules, const NodeClustering& wholes,
             NodeComponents& result);

 private:
  /// Of each whole: whether it is split, its parts that are large enough, and the largest of all.
  struct Verdict {
    bool split = false;
    std::vector<std::int32_t> parts;
    std::int32_t largest = -1;
  };

  bool selectLarge(const NodeClustering& wholes);
  void clusterAgain(const ObjectNodes& nodes, const LinkRules& rules, const NodeClustering& wholes);
  void judge(const LinkRules& rules, std::size_t count);
  /// Adds a run of a component, which gets its final number with its first run.
  void addPiece(const RowRuns& runs, std::size_t run, std::int32_t component,
                const Component& measure, NodeComponents& result);

  float extent_, factor_;
  NodeClustering parts_;
  NodeWindows windows_;
  /// Whether each run of the wholes is clustered again.
  std::vector<std::uint8_t> selected_;
  std::vector<std::int32_t> wholeOfPart_;
  std::vector<Verdict> verdicts_;
  /// Part that each part is counted to.
  std::vector<std::int32_t> target_;
  /// Measure of all parts that are counted to each part.
  std::vector<Component> measureOfTarget_;
  /// Final number of each whole and, after them, of each part; -1 before it is met.
  std::vector<std::int32_t> number_;
};

}  // namespace toss
