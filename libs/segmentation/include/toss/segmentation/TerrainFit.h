// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/TerrainRefinement.h>
#include <toss/segmentation/UprightNeighbours.h>

#include <array>
#include <cstdint>
#include <vector>

namespace toss {

/// Fits the terrain, one surface of flat triangles over the whole field, to the returns near it:
/// regularised least squares for the vertex heights. Where returns are dense they decide; where a
/// beam leaves one line of returns per triangle, smoothness carries the surface on, which planes of
/// single triangles can't (our addition to spec section 2.4).
class TerrainFit {
 public:
  /// `field` must outlive this.
  explicit TerrainFit(const TriGridField& field);

  /// Gives vertices without a height next to known ones the height that continues the surface
  /// straight on. One call extends it by about one triangle.
  void extend(VertexHeights& heights);

  /// Starts a new selection of returns.
  void clear() { sums_.clear(); }
  /// Adds returns of `node` that lie near the surface: their weight fades out at `gate` [m] below
  /// it and nearer above it, where feet and bumpers are. Nodes with an unknown vertex are left out,
  /// and so are returns clearly above the surface that `upright` (may be null) finds to belong to
  /// something upright: they would lift the surface where no ground is seen in front of them.
  void add(int node, const NodePoints& points, const VertexHeights& heights, float gate,
           const UprightNeighbours* upright);
  /// Moves the heights of the vertices at and around the selected returns to the best compromise
  /// between returns and smoothness.
  void solve(VertexHeights& heights);

 private:
  /// Weighted sums over a node's returns of products of their barycentric coordinates (00, 01, 02,
  /// 11, 12, 22), and of these with the height.
  struct NodeSums {
    std::array<std::int32_t, 3> vertices;
    std::array<float, 6> products;
    std::array<float, 3> heights;
  };
  /// Returns of one node that the fit looks at, evenly picked, side by side.
  struct Picked {
    static constexpr std::size_t kMost = 24;
    using Each = std::array<float, kMost>;
    /// Offsets to the centre of the square in half sides, and height in the level frame [m].
    Each dx{}, dy{}, z{};
    /// Barycentric coordinates; distance above the surface [m]; weight in the fit.
    Each l0, l1, l2, height, weight;

    /// Weighs returns of triangle `side` of a square by their distance from the surface whose
    /// vertices have the heights `h` [m]; `below`, `above`: inverse of the largest distance [1/m].
    void weigh(int side, const std::array<float, 3>& h, float below, float above);
  };
  /// Four vertices whose heights, with these factors, add up to 0 where the surface is straight.
  struct Stencil {
    std::array<std::int32_t, 4> vertices;
    std::array<float, 4> factors;
  };

  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  void markEdges(const VertexHeights& heights);
  void continueAlong(const Stencil& stencil, const VertexHeights& heights);
  void activate(const VertexHeights& heights);
  std::int32_t unknownOf(std::int32_t vertex);
  void buildSystem(const VertexHeights& heights);
  void multiply(const std::vector<float>& values, std::vector<float>& product) const;
  void iterate();

  const TriGridField& field_;
  /// Those of one square after the other, and the first of each square, shape [squares + 1].
  std::vector<Stencil> stencils_;
  std::vector<std::int32_t> stencilBegin_;
  std::vector<NodeSums> sums_;

  /// The system of the last selection: its unknowns are the vertices `vertexOf_`.
  std::vector<Stencil> active_;
  std::vector<std::int32_t> unknownOf_, vertexOf_;
  std::vector<float> solution_, inverseDiagonal_, residual_, direction_, product_, scaled_;
  Picked picked_;
  /// Buffers of extend(), shape [vertices].
  std::vector<float> sum_, count_;
  /// Vertices without a height, and squares at the edge of what is known; 1 or 0.
  std::vector<std::uint8_t> unknown_, edges_;
};

}  // namespace toss
