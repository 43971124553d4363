// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LargeComponentSplit.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Gives the points of the nodes in `leftover` and of their mates to the instance of the node
/// nearest to each, if that is within `distance` [m] in three dimensions (spec section 11). Only
/// instances as clustered take points, so that nothing hangs on a chain. `instanceOfNode`: 0 =
/// none, shape [nodes].
void attachLeftoverPoints(const LevelPoints& points, const RangeImage& image,
                          const LinkRules& rules, const ObjectNodes& nodes,
                          const std::vector<std::int32_t>& instanceOfNode,
                          const std::vector<NodeComponents::Piece>& leftover, float distance,
                          Segmentation& segmentation);

}  // namespace toss
