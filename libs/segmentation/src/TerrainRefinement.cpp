// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/TerrainRefinement.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace toss {
namespace {

/// Keeps the weight of a patch finite whose mean lies on a vertex [m].
constexpr float kNearest = 1e-3f;

}  // namespace

void averageVertices(const TriGridField& field, const std::vector<GroundNode>& nodes,
                     VertexHeights& heights) {
  const auto n = static_cast<std::size_t>(field.vertices());
  std::vector<float> weights(n, 0.0f);
  heights.assign(n, 0.0f);
  for (int index = 0; index < field.nodes(); ++index) {
    const GroundNode& node = nodes[static_cast<std::size_t>(index)];
    if (!node.isGround()) continue;
    for (const int vertex : field.verticesOf(index)) {
      const Eigen::Vector2f q = field.vertexPosition(vertex);
      const float height = -(node.normal.head<2>().dot(q) + node.offset) / node.normal.z();
      const float weight = node.weight / ((node.mean.head<2>() - q).norm() + kNearest);
      heights[static_cast<std::size_t>(vertex)] += weight * height;
      weights[static_cast<std::size_t>(vertex)] += weight;
    }
  }
  for (std::size_t v = 0; v < n; ++v) {
    const bool known = weights[v] > 0.0f;
    heights[v] = known ? heights[v] / weights[v] : std::numeric_limits<float>::quiet_NaN();
  }
}

void replacePlane(const TriGridField& field, const GroundOptions& options,
                  const VertexHeights& heights, int index, GroundNode& node) {
  std::array<Eigen::Vector3f, 3> q;
  const std::array<std::int32_t, 3>& vertices = field.verticesOf(index);
  for (std::size_t i = 0; i < 3; ++i) {
    q[i] << field.vertexPosition(vertices[i]), heights[static_cast<std::size_t>(vertices[i])];
  }
  if (!std::isfinite(q[0].z() + q[1].z() + q[2].z())) {
    if (node.type != NodeType::NonGround) node.type = NodeType::Unknown;
    return;
  }
  node.normal = (q[0] - q[2]).cross(q[1] - q[2]).normalized();
  node.offset = -node.normal.dot(q[2]);
  const bool level = node.normal.z() >= static_cast<float>(options.minNormalZ);
  node.type = level ? NodeType::Ground : NodeType::NonGround;
}

void replacePlanes(const TriGridField& field, const GroundOptions& options,
                   const VertexHeights& heights, std::vector<GroundNode>& nodes) {
  for (int index = 0; index < field.nodes(); ++index) {
    replacePlane(field, options, heights, index, nodes[static_cast<std::size_t>(index)]);
  }
}

}  // namespace toss
