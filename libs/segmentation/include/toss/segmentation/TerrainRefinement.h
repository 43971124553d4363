// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundNodeModel.h>
#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/TriGridField.h>

#include <vector>

namespace toss {

/// Heights of the field's vertices [m, level frame], NaN where unknown, shape [field.vertices()].
using VertexHeights = std::vector<float>;

/// Height of each vertex: mean over the Ground nodes around it, weighted by their weight and
/// nearness (spec section 2.4).
void averageVertices(const TriGridField& field, const std::vector<GroundNode>& nodes,
                     VertexHeights& heights);

/// Plane of one node through its three vertices: Ground where it is no steeper than allowed, else
/// NonGround; without all three vertices Unknown unless it is NonGround (spec section 2.4).
void replacePlane(const TriGridField& field, const GroundOptions& options,
                  const VertexHeights& heights, int index, GroundNode& node);

/// The same for all nodes, which revives those between others.
void replacePlanes(const TriGridField& field, const GroundOptions& options,
                   const VertexHeights& heights, std::vector<GroundNode>& nodes);

}  // namespace toss
