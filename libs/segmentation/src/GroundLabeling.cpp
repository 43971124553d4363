// SPDX-License-Identifier: BSD-3-Clause
#include "GroundLabeling.h"

#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>

#include <algorithm>
#include <array>
#include <limits>

namespace toss {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
/// Ground returns that make a triangle ground which a beam can't pass through.
constexpr int kGroundReturns = 3;

constexpr std::size_t kBlock = 512;

/// Makes ground what lies between `below` and `above`, and marks what lies lower. The compiler
/// vectorises this only as a function of arrays that are known not to overlap.
TOSS_ALSO_FOR_AVX2
void classify(const float* __restrict height, float above, float below, std::size_t n,
              PointClass* __restrict pointClass, std::uint8_t* __restrict low) {
  for (std::size_t i = 0; i < n; ++i) {
    const bool isGround = (height[i] < above) & (height[i] >= below);
    pointClass[i] = isGround ? PointClass::Ground : pointClass[i];
    low[i] = static_cast<std::uint8_t>(height[i] < below);
  }
}

bool isMetGround(const NodePoints& points, const Segmentation& segmentation) {
  int found = 0;
  for (std::size_t i = 0; i < points.count && found < kGroundReturns; ++i) {
    const auto point = static_cast<std::size_t>(points[i].original);
    found += segmentation.pointClass[point] == PointClass::Ground ? 1 : 0;
  }
  return found == kGroundReturns;
}

}  // namespace

void GroundLabeling::labelBlock(const LevelPoints& points, const std::vector<std::int32_t>& nodeOf,
                                const std::vector<GroundNode>& nodes, std::size_t begin,
                                std::size_t size, const GroundOptions& options,
                                Segmentation& segmentation) {
  const GroundNode none;
  float* const height = segmentation.heightAboveGround.data() + begin;
  for (std::size_t i = 0; i < size; ++i) {
    const std::int32_t index = nodeOf[begin + i];
    const GroundNode& node = index < 0 ? none : nodes[static_cast<std::size_t>(index)];
    const std::size_t point = begin + i;
    const float distance = node.heightOf(points.x[point], points.y[point], points.z[point]);
    height[i] = node.isGround() ? distance : kUnknown;
  }
  std::array<std::uint8_t, kBlock> low{};
  classify(height, static_cast<float>(options.groundHeight),
           -static_cast<float>(options.outlierDepth), size, segmentation.pointClass.data() + begin,
           low.data());
  visitMarks(low.data(), kBlock,
             [&](std::size_t i) { low_.push_back(static_cast<std::int32_t>(begin + i)); });
}

void GroundLabeling::label(const LevelPoints& points, const NodeSorting& sorted,
                           const TriGridField& field, const std::vector<GroundNode>& nodes,
                           const GroundOptions& options, Segmentation& segmentation) {
  segmentation.heightAboveGround.resize(points.x.size());
  low_.clear();
  const std::size_t n = points.x.size();
  for (std::size_t begin = 0; begin < n; begin += kBlock)
    labelBlock(points, sorted.nodeOfReturns(), nodes, begin, std::min(kBlock, n - begin), options,
               segmentation);
  // A beam that has passed through ground which other beams have met was reflected. Where there is
  // no such ground, it has gone down into a ditch or beyond an edge.
  for (const std::int32_t each : low_) {
    const auto point = static_cast<std::size_t>(each);
    const Eigen::Vector3f beam(points.x[point], points.y[point], points.z[point]);
    const auto own = static_cast<std::size_t>(sorted.nodeOfReturns()[point]);
    // The sensor is `offset` above the plane, so this share of the beam runs above it.
    const float offset = nodes[own].offset;
    if (!(offset > 0.0f)) continue;
    const float shareAbove = offset / (offset - segmentation.heightAboveGround[point]);
    const float under = (1.0f - shareAbove) * beam.norm();
    if (under < static_cast<float>(options.minBuriedPath)) continue;
    const int node = field.nodeOf(beam.x() * shareAbove, beam.y() * shareAbove);
    const bool throughGround = node >= 0 && isMetGround(sorted.ofFine(node), segmentation);
    if (throughGround || options.minBuriedPath == 0.0)
      segmentation.pointClass[point] = PointClass::BelowGround;
  }
}

}  // namespace toss
