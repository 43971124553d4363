// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  /// Height of the plane at a position [m, level frame].
  float planeHeight(float x, float y) const {
    return -(normal.x() * x + normal.y() * y + offset) / normal.z();
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

}  // namespace toss
