// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/segmentation/TriGridField.h>

#include <cstdint>
#include <vector>

namespace toss {

/// The returns of a scan grouped by node (counting sort, so that each node's lie side by side in
/// memory, in the order of the scan).
class NodeSorting {
 public:
  /// Groups the returns that are Unclustered, i.e. not yet decided, and lie inside the field.
  void sort(const LevelPoints& points, const std::vector<PointClass>& pointClass,
            const TriGridField& field);

  NodePoints pointsOf(std::size_t node) const {
    const auto first = static_cast<std::size_t>(begin_[node]);
    return {x_.data() + first, y_.data() + first, z_.data() + first,
            static_cast<std::size_t>(begin_[node + 1]) - first};
  }
  /// Indices in the scan of the node's returns.
  const std::int32_t* originalOf(std::size_t node) const {
    return original_.data() + begin_[node];
  }

 private:
  /// Node of each return, -1 for none, shape [n].
  std::vector<std::int32_t> node_;
  std::vector<std::int32_t> begin_, cursor_, original_;
  std::vector<float> x_, y_, z_;
};

}  // namespace toss
