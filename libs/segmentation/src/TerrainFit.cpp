// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/TerrainFit.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// The most that the returns of one node weigh together.
constexpr float kFullWeight = 16.0f;
/// Share of the gate that reaches above the surface.
constexpr float kAbove = 0.6f;
/// Height above the surface from which a return may lie on something upright rather than on ground
/// that is higher than thought [m].
constexpr float kClearlyAbove = 0.05f;
/// Weight of a unit bend against a return: a return off by 0.05 m costs as much as a bend of 0.1 m.
constexpr float kSmoothness = 0.25f;
/// Steps of the solver; it starts near the solution.
constexpr int kSteps = 5;
constexpr std::int32_t kNone = -1;

float dot(const std::vector<float>& a, const std::vector<float>& b) {
  // Four sums side by side, in a fixed order, so that the result is the same everywhere.
  std::array<float, 4> sums = {};
  const std::size_t whole = a.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
  }
  for (std::size_t i = whole; i < a.size(); ++i) sums[0] += a[i] * b[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

TerrainFit::TerrainFit(const TriGridField& field) : field_(field) {
  const int side = field_.side();
  const auto corner = [side](int r, int c) { return r * (side + 1) + c; };
  const auto centre = [side](int r, int c) { return (side + 1) * (side + 1) + r * side + c; };
  for (int r = 0; r < side; ++r) {
    for (int c = 0; c < side; ++c) {
      const int m = centre(r, c);
      stencilBegin_.push_back(static_cast<std::int32_t>(stencils_.size()));
      // A centre lies half-way between opposite corners ...
      stencils_.push_back({{corner(r, c), corner(r + 1, c + 1), m, m}, {1, 1, -2, 0}});
      stencils_.push_back({{corner(r + 1, c), corner(r, c + 1), m, m}, {1, 1, -2, 0}});
      // ... and the middle of an edge half-way between the centres on its two sides.
      const int shared = corner(r + 1, c + 1);
      if (r + 1 < side) {
        stencils_.push_back({{corner(r + 1, c), shared, m, centre(r + 1, c)}, {1, 1, -1, -1}});
      }
      if (c + 1 < side) {
        stencils_.push_back({{corner(r, c + 1), shared, m, centre(r, c + 1)}, {1, 1, -1, -1}});
      }
    }
  }
  stencilBegin_.push_back(static_cast<std::int32_t>(stencils_.size()));
}

/// The corners of the triangle lie at a + b and a - b of the axis a towards its side, turned by 90
/// degrees b. The compiler vectorises it only as a function of its own.
TOSS_ALSO_FOR_AVX2
void TerrainFit::Picked::weigh(int side, const std::array<float, 3>& h, float below, float above) {
  const float* const towards = side % 2 == 0 ? dx.data() : dy.data();
  const float* const aside = side % 2 == 0 ? dy.data() : dx.data();
  const float signAlong = side < 2 ? 1.0f : -1.0f, signAcross = side % 3 == 0 ? 1.0f : -1.0f;
  const float h0 = h[0], h1 = h[1], h2 = h[2];
  for (std::size_t i = 0; i < kMost; ++i) {
    const float along = signAlong * towards[i], across = signAcross * aside[i];
    l0[i] = 0.5f * (along - across), l1[i] = 0.5f * (along + across), l2[i] = 1.0f - along;
    height[i] = z[i] - (l0[i] * h0 + l1[i] * h1 + l2[i] * h2);
    const float off = height[i] * (height[i] > 0.0f ? above : below);
    const float fade = std::max(0.0f, 1.0f - off * off);
    weight[i] = fade * fade;
  }
}

void TerrainFit::add(int node, const NodePoints& points, const VertexHeights& heights, float gate,
                     const UprightNeighbours* upright) {
  if (points.count == 0) return;
  NodeSums sums{field_.verticesOf(node), {}, {}};
  const float h0 = heights[at(sums.vertices[0])], h1 = heights[at(sums.vertices[1])];
  const float h2 = heights[at(sums.vertices[2])];
  if (std::isnan(h0 + h1 + h2)) return;

  const Eigen::Vector2f& centre = field_.vertexPosition(sums.vertices[2]);
  const float halfSides = 2.0f / field_.cellSize();
  const std::size_t stride = (points.count + Picked::kMost - 1) / Picked::kMost;
  Picked& picked = picked_;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.count; i += stride, ++count) {
    picked.dx[count] = (points[i].x - centre.x()) * halfSides;
    picked.dy[count] = (points[i].y - centre.y()) * halfSides;
    picked.z[count] = points[i].z;
  }
  picked.weigh(node % 4, {h0, h1, h2}, 1.0f / gate, 1.0f / (kAbove * gate));
  float total = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    float w = picked.weight[i];
    const bool clearlyAbove = (w > 0.0f) & (picked.height[i] > kClearlyAbove);
    if (upright != nullptr && clearlyAbove &&
        upright->anyAbove(static_cast<std::size_t>(points[i * stride].original))) {
      w = 0.0f;
    }
    const float l0 = picked.l0[i], l1 = picked.l1[i], l2 = picked.l2[i], wz = w * picked.z[i];
    sums.products[0] += w * l0 * l0, sums.products[1] += w * l0 * l1;
    sums.products[2] += w * l0 * l2, sums.products[3] += w * l1 * l1;
    sums.products[4] += w * l1 * l2, sums.products[5] += w * l2 * l2;
    sums.heights[0] += wz * l0, sums.heights[1] += wz * l1, sums.heights[2] += wz * l2;
    total += w;
  }
  if (total == 0.0f) return;
  const float scale = kFullWeight / std::max(total, kFullWeight);
  for (float& product : sums.products) product *= scale;
  for (float& height : sums.heights) height *= scale;
  sums_.push_back(sums);
}

std::int32_t TerrainFit::unknownOf(std::int32_t vertex) {
  std::int32_t& unknown = unknownOf_[at(vertex)];
  if (unknown == kNone) {
    unknown = static_cast<std::int32_t>(vertexOf_.size());
    vertexOf_.push_back(vertex);
  }
  return unknown;
}

/// Numbers the unknowns: the vertices of nodes with selected returns, then those that share a
/// stencil with them. From here on sums and active stencils speak of unknowns, not of vertices.
void TerrainFit::activate(const VertexHeights& heights) {
  unknownOf_.assign(heights.size(), kNone);
  vertexOf_.clear();
  active_.clear();
  for (NodeSums& node : sums_) {
    for (std::int32_t& vertex : node.vertices) vertex = unknownOf(vertex);
  }
  const auto selected = static_cast<std::uint32_t>(vertexOf_.size());
  for (const Stencil& stencil : stencils_) {
    bool near = false;
    float sum = 0.0f;
    for (const std::int32_t vertex : stencil.vertices) {
      // As an unsigned number, none is beyond all.
      near |= static_cast<std::uint32_t>(unknownOf_[at(vertex)]) < selected;
      sum += heights[at(vertex)];
    }
    if (!near || std::isnan(sum)) continue;
    active_.push_back(stencil);
    for (std::int32_t& vertex : active_.back().vertices) vertex = unknownOf(vertex);
  }
}

void TerrainFit::buildSystem(const VertexHeights& heights) {
  const std::size_t n = vertexOf_.size();
  solution_.resize(n);
  for (std::size_t i = 0; i < n; ++i) solution_[i] = heights[at(vertexOf_[i])];
  inverseDiagonal_.assign(n, 0.0f);
  residual_.assign(n, 0.0f);
  for (const NodeSums& node : sums_) {
    inverseDiagonal_[at(node.vertices[0])] += node.products[0];
    inverseDiagonal_[at(node.vertices[1])] += node.products[3];
    inverseDiagonal_[at(node.vertices[2])] += node.products[5];
    for (std::size_t i = 0; i < 3; ++i) residual_[at(node.vertices[i])] += node.heights[i];
  }
  for (const Stencil& stencil : active_) {
    for (std::size_t i = 0; i < 4; ++i) {
      const float factor = stencil.factors[i];
      inverseDiagonal_[at(stencil.vertices[i])] += kSmoothness * factor * factor;
    }
  }
  multiply(solution_, product_);
  for (std::size_t i = 0; i < n; ++i) {
    residual_[i] -= product_[i];
    inverseDiagonal_[i] = 1.0f / std::max(inverseDiagonal_[i], 1e-12f);
  }
}

void TerrainFit::multiply(const std::vector<float>& values, std::vector<float>& product) const {
  product.assign(values.size(), 0.0f);
  for (const NodeSums& node : sums_) {
    const std::size_t v0 = at(node.vertices[0]), v1 = at(node.vertices[1]);
    const std::size_t v2 = at(node.vertices[2]);
    const std::array<float, 6>& p = node.products;
    const float a = values[v0], b = values[v1], c = values[v2];
    product[v0] += p[0] * a + p[1] * b + p[2] * c;
    product[v1] += p[1] * a + p[3] * b + p[4] * c;
    product[v2] += p[2] * a + p[4] * b + p[5] * c;
  }
  for (const Stencil& stencil : active_) {
    float bend = 0.0f;
    for (std::size_t i = 0; i < 4; ++i)
      bend += stencil.factors[i] * values[at(stencil.vertices[i])];
    bend *= kSmoothness;
    for (std::size_t i = 0; i < 4; ++i)
      product[at(stencil.vertices[i])] += bend * stencil.factors[i];
  }
}

/// Conjugate gradients, preconditioned by the diagonal.
void TerrainFit::iterate() {
  const std::size_t n = solution_.size();
  scaled_.resize(n);
  direction_.assign(n, 0.0f);
  float previous = 1.0f;
  for (int step = 0; step < kSteps; ++step) {
    for (std::size_t i = 0; i < n; ++i) scaled_[i] = inverseDiagonal_[i] * residual_[i];
    const float size = dot(residual_, scaled_);
    const float keep = step == 0 ? 0.0f : size / previous;
    for (std::size_t i = 0; i < n; ++i) direction_[i] = scaled_[i] + keep * direction_[i];
    multiply(direction_, product_);
    const float curvature = dot(direction_, product_);
    if (!(size > 0.0f) || !(curvature > 0.0f)) return;
    const float length = size / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      solution_[i] += length * direction_[i];
      residual_[i] -= length * product_[i];
    }
    previous = size;
  }
}

void TerrainFit::solve(VertexHeights& heights) {
  activate(heights);
  buildSystem(heights);
  iterate();
  for (std::size_t i = 0; i < vertexOf_.size(); ++i) heights[at(vertexOf_[i])] = solution_[i];
}

}  // namespace toss
