// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/TriGridField.h>

#include <vector>

namespace toss {

/// Whether a robot can go from one patch to the other: local convexity/concavity (spec section
/// 2.3). Symmetric.
bool isTraversable(const GroundNode& a, const GroundNode& b, const GroundOptions& options);

/// Breadth-first search over Ground nodes from the best one near the robot. Nodes that are not
/// reached over traversable edges become NonGround; islands are treated by policy (spec section
/// 2.3). `nodes`: shape [field.nodes()].
void searchTraversable(const TriGridField& field, const GroundOptions& options,
                       std::vector<GroundNode>& nodes);

}  // namespace toss
