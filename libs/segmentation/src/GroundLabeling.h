// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/segmentation/TriGridField.h>

#include <cstdint>
#include <vector>

#include "NodeSorting.h"

namespace toss {

/// Classes and heights of returns by the planes of their nodes. Goes through the returns in the
/// order of the scan: node by node, what is written would be scattered over memory.
class GroundLabeling {
 public:
  /// Sets heightAboveGround (all) and pointClass (of what lies on or below the ground). `nodes`: of
  /// `field`, the fine one that `sorted` was made with. Keeps its buffers from scan to scan.
  void label(const LevelPoints& points, const NodeSorting& sorted, const TriGridField& field,
             const std::vector<GroundNode>& nodes, const GroundOptions& options,
             Segmentation& segmentation);

 private:
  /// Heights and Ground of `size` returns from `begin` on.
  void labelBlock(const LevelPoints& points, const std::vector<std::int32_t>& nodeOf,
                  const std::vector<GroundNode>& nodes, std::size_t begin, std::size_t size,
                  const GroundOptions& options, Segmentation& segmentation);

  /// Returns below the ground.
  std::vector<std::int32_t> low_;
};

}  // namespace toss
