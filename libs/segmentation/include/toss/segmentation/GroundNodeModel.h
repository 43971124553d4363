// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundOptions.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

enum class NodeType : std::uint8_t { Unknown, NonGround, Ground };

/// One triangle of the field with the plane of its lowest returns (spec section 2.1, 2.2).
struct GroundNode {
  NodeType type = NodeType::Unknown;
  /// Unit normal, z not negative; plane: normal . p + offset = 0 [m, level frame].
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  float offset = 0.0f;
  /// Mean of the returns that the plane was fitted to [m, level frame].
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  /// (s1 + s2) s2 / (s1 s3 + 0.001) of the eigenvalues: flat, evenly spread patches weigh most.
  float weight = 0.0f;

  bool isGround() const { return type == NodeType::Ground; }
  /// Distance above the plane [m].
  float heightOf(float x, float y, float z) const {
    return normal.x() * x + normal.y() * y + normal.z() * z + offset;
  }
};

/// A return of a node [m, level frame] with its index in the scan.
struct NodePoint {
  float x, y, z;
  std::int32_t original;
};

/// Returns of one node. Sorting a scan by nodes scatters the returns over memory, hence one record
/// each rather than a struct of arrays.
struct NodePoints {
  const NodePoint* begin = nullptr;
  std::size_t count = 0;

  const NodePoint& operator[](std::size_t i) const { return begin[i]; }
};

/// Fits the ground plane of a node (region-wise ground plane fitting, spec section 2.2): a few
/// rounds of fit and re-selection, started at the lowest layer of returns that is no reflection.
GroundNode fitGroundNode(const NodePoints& points, const GroundOptions& options);

/// Height [m] at which the fit starts: the mean of the lowest returns, above layers so thin that
/// they are reflections from under the ground (spec section 2.8).
float lowestLayer(const NodePoints& points, const GroundOptions& options);

}  // namespace toss
