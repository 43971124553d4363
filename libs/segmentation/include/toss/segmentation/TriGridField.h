// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace toss {

/// A square field of squares, each cut by its diagonals into four triangles, the nodes (spec
/// section 2.1). Centred on the sensor, level frame. Rows grow along x, columns along y; triangle 0
/// of a square lies at its +x side, 1 at +y, 2 at -x, 3 at -y. Node = 4 * square + triangle, square
/// = row * side + column. Vertices: the (side + 1)^2 corners row by row, then the centres.
class TriGridField {
 public:
  /// `extent`: half the side of the field [m], rounded down to whole squares (at least 2 x 2);
  /// `cellSize`: side of a square [m]. Both must be greater than 0.
  TriGridField(double extent, double cellSize);
  /// The same square cut finer, `factor` squares for one along either axis: each of its nodes lies
  /// in a single node of this field.
  TriGridField refined(int factor) const;

  /// Half the side of the field [m].
  float extent() const { return half_; }
  /// Squares per side.
  int side() const { return side_; }
  int nodes() const { return 4 * side_ * side_; }
  int vertices() const { return (side_ + 1) * (side_ + 1) + side_ * side_; }
  float cellSize() const { return cellSize_; }

  /// Node of a position [m, level frame]; -1 outside the field and for NaN.
  int nodeOf(float x, float y) const {
    const auto limit = static_cast<float>(side_);
    const float u = (x + half_) * squaresPerMetre_, v = (y + half_) * squaresPerMetre_;
    const bool inside = (u >= 0.0f) & (v >= 0.0f) & (u < limit) & (v < limit);
    // Arithmetic throughout, so that loops over it are vectorised.
    const float heldU = std::min(std::max(0.0f, u), limit),
                heldV = std::min(std::max(0.0f, v), limit);
    const int row = static_cast<int>(heldU), column = static_cast<int>(heldV);
    const float dx = heldU - static_cast<float>(row) - 0.5f;
    const float dy = heldV - static_cast<float>(column) - 0.5f;
    // Which side of either diagonal; a position on a diagonal belongs to one of its two sides.
    const int left = static_cast<int>(dy >= dx), below = static_cast<int>(dy < -dx);
    const int triangle = left ^ (3 * below);
    return (4 * (row * side_ + column) + triangle) | -static_cast<int>(!inside);
  }

  /// The two corners of a node in counter-clockwise order, and its centre vertex.
  const std::array<std::int32_t, 3>& verticesOf(int node) const {
    return verticesOf_[static_cast<std::size_t>(node)];
  }
  /// Position of a vertex [m, level frame].
  const Eigen::Vector2f& vertexPosition(int vertex) const {
    return positions_[static_cast<std::size_t>(vertex)];
  }
  /// Mean of a node's vertices [m, level frame].
  Eigen::Vector2f centroidOf(int node) const;
  /// Squares that a node's square is away from the sensor, along the farther axis: 0 for the four
  /// squares around it.
  int ringOf(int node) const;

  /// Nodes that share at least one vertex with `node`, ascending: 14 inside the field.
  const std::int32_t* neighboursBegin(int node) const {
    return neighbours_.data() + neighbourBegin_[static_cast<std::size_t>(node)];
  }
  const std::int32_t* neighboursEnd(int node) const {
    return neighbours_.data() + neighbourBegin_[static_cast<std::size_t>(node) + 1];
  }

 private:
  TriGridField(int side, float cellSize);
  void placeVertices();
  void connectNodes();
  void findNeighbours();

  int side_;
  float cellSize_, half_, squaresPerMetre_;
  std::vector<Eigen::Vector2f> positions_;
  std::vector<std::array<std::int32_t, 3>> verticesOf_;
  std::vector<std::int32_t> neighbours_, neighbourBegin_;
};

}  // namespace toss
