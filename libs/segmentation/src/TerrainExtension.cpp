// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/TerrainFit.h>

#include <cmath>

namespace toss {
namespace {

// The compiler vectorises these only as functions of arrays that are known not to overlap.

TOSS_ALSO_FOR_AVX2
void markUnknown(const float* __restrict height, std::size_t n, std::uint8_t* __restrict unknown) {
  for (std::size_t i = 0; i < n; ++i)
    unknown[i] = static_cast<std::uint8_t>(height[i] != height[i]);
}

/// Marks the squares of a row around which vertices are known as well as unknown: the corners on
/// either side of the row, its centres, and those of the next row and of the next square. The last
/// square has none beside it, and is marked whatever its vertices are.
TOSS_ALSO_FOR_AVX2
void markMixed(const std::uint8_t* __restrict corners, const std::uint8_t* __restrict nextCorners,
               const std::uint8_t* __restrict centres, const std::uint8_t* __restrict nextCentres,
               std::size_t squares, std::uint8_t* __restrict mixed) {
  for (std::size_t c = 0; c + 1 < squares; ++c) {
    const int any = corners[c] | corners[c + 1] | nextCorners[c] | nextCorners[c + 1] | centres[c] |
                    centres[c + 1] | nextCentres[c];
    const int all = corners[c] & corners[c + 1] & nextCorners[c] & nextCorners[c + 1] & centres[c] &
                    centres[c + 1] & nextCentres[c];
    mixed[c] = static_cast<std::uint8_t>(any ^ all);
  }
  mixed[squares - 1] = 1;
}

}  // namespace

/// Marks the squares that may hold a vertex to give a height to: of a stencil that begins in the
/// square, just one vertex is unknown. Most of a field is known all around, or unknown.
void TerrainFit::markEdges(const VertexHeights& heights) {
  const auto side = static_cast<std::size_t>(field_.side());
  unknown_.resize(heights.size());
  markUnknown(heights.data(), heights.size(), unknown_.data());
  edges_.assign(roundedToBlocks(side * side), 0);
  const std::uint8_t* const centres = unknown_.data() + (side + 1) * (side + 1);
  for (std::size_t row = 0; row < side; ++row) {
    const std::uint8_t* const corners = unknown_.data() + row * (side + 1);
    const std::uint8_t* const centre = centres + row * side;
    markMixed(corners, corners + side + 1, centre, row + 1 < side ? centre + side : centre, side,
              edges_.data() + row * side);
  }
}

void TerrainFit::extend(VertexHeights& heights) {
  sum_.assign(heights.size(), 0.0f);
  count_.assign(heights.size(), 0.0f);
  markEdges(heights);
  visitMarks(edges_.data(), edges_.size(), [&](std::size_t square) {
    const std::int32_t end = stencilBegin_[square + 1];
    for (std::int32_t s = stencilBegin_[square]; s < end; ++s)
      continueAlong(stencils_[at(s)], heights);
  });
  for (std::size_t v = 0; v < heights.size(); ++v) {
    if (count_[v] > 0.0f) heights[v] = sum_[v] / count_[v];
  }
}

void TerrainFit::continueAlong(const Stencil& stencil, const VertexHeights& heights) {
  // Without branches: what is known changes from stencil to stencil. The place is that of the
  // unknown vertex if there is just one.
  float rest = 0.0f;
  std::size_t unknowns = 0, place = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const float factor = stencil.factors[i], height = heights[at(stencil.vertices[i])];
    const bool isUnknown = std::isnan(height);
    const auto missing = static_cast<std::size_t>(isUnknown & (factor != 0.0f));
    unknowns += missing, place += missing * i;
    rest += isUnknown ? 0.0f : factor * height;
  }
  if (unknowns != 1) return;
  const std::size_t unknown = at(stencil.vertices[place]);
  sum_[unknown] -= rest / stencil.factors[place];
  count_[unknown] += 1.0f;
}

}  // namespace toss
