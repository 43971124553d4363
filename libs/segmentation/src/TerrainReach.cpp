// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainReach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

/// Distance from the surface up to which returns take part in the fit, and up to which they lie on
/// ground that is continued straight on [m].
constexpr float kGate = 0.4f, kNear = 0.3f;
/// Returns of a patch that are looked at, evenly picked, and the fewest of them on the surface.
constexpr std::size_t kMost = 64, kFewest = 3;
/// Length of their line as share of a patch, longer than people and cars; and where the patch hangs
/// on two known vertices, so that it can hardly tilt.
constexpr float kLeastLength = 0.45f, kLeastHanging = 0.23f;
/// Share of all on the surface, and under it for one on it.
constexpr float kLeastOn = 0.6f, kMostUnder = 0.02f;

/// Distance between rings [m] that leaves patches out. Where they are nearer to each other, as on
/// stairs, what is no ground by itself is none.
constexpr float kLeastGap = 3.0f;

/// Where the returns of a patch lie.
struct Returns {
  std::size_t on = 0, under = 0, all = 0;
  Eigen::AlignedBox2f line;
  /// Range of the farthest, squared [m^2].
  float squaredRange = 0.0f;

  void add(const Eigen::Vector3f& point, float height) {
    ++all;
    squaredRange = std::max(squaredRange, point.squaredNorm());
    under += height < -kNear;
    if (std::fabs(height) >= kNear) return;
    ++on;
    line.extend(point.head<2>());
  }
  /// `planeDistance`: of the sensor from the surface [m].
  bool areSingleRings(float spacing, float planeDistance) const {
    return spacing * squaredRange >= kLeastGap * planeDistance;
  }
  /// `length`: least that their line has [m].
  bool areGround(float length) const {
    const auto share = [](std::size_t n, float of) { return of * static_cast<float>(n); };
    return on >= kFewest && line.sizes().maxCoeff() >= length &&
           share(under, 1.0f) <= share(on, kMostUnder) && share(on, 1.0f) >= share(all, kLeastOn);
  }
};

}  // namespace

bool TerrainReach::isNeeded(const RangeImage& image, const GroundOptions& options) {
  return options.reachRounds > 0 && image.meanRowSpacing() > options.reachSpacing * M_PI / 180.0;
}

int TerrainReach::verticesWith(Knowledge least, int node) const {
  int count = 0;
  for (const std::int32_t v : field_.verticesOf(node))
    count += knowledge_[static_cast<std::size_t>(v)] >= least;
  return count;
}

bool TerrainReach::isGround(int node, const NodePoints& points, const GroundOptions& options,
                            const VertexHeights& heights) const {
  GroundNode plane;
  replacePlane(field_, options, heights, node, plane);
  if (!plane.isGround()) return false;
  Returns returns;
  const std::size_t stride = points.count / kMost + 1;
  for (std::size_t i = 0; i < points.count; i += stride) {
    const Eigen::Vector3f p(points[i].x, points[i].y, points[i].z);
    returns.add(p, (plane.normal.dot(p) + plane.offset) / plane.normal.z());
  }
  const float length = verticesWith(Supported, node) < 2 ? kLeastLength : kLeastHanging;
  return returns.areSingleRings(rowSpacing_, std::fabs(plane.offset)) &&
         returns.areGround(length * field_.cellSize());
}

void TerrainReach::carryOnce(const NodeSorting& sorted, const UprightNeighbours& upright,
                             const GroundOptions& options, VertexHeights& heights) {
  fit_.extend(heights);
  fit_.clear();
  for (int node = 0; node < field_.nodes(); ++node) {
    const NodePoints points = sorted.ofCoarse(node);
    if (verticesWith(Given, node) < 3 && !isGround(node, points, options, heights)) continue;
    for (const std::int32_t v : field_.verticesOf(node)) {
      Knowledge& knowledge = knowledge_[static_cast<std::size_t>(v)];
      if (knowledge == Assumed) knowledge = Supported;
    }
    fit_.add(node, points, heights, kGate, &upright);
  }
  fit_.solve(heights);
}

void TerrainReach::carryOn(const RangeImage& image, const NodeSorting& sorted,
                           const UprightNeighbours& upright, const GroundOptions& options,
                           VertexHeights& heights) {
  rowSpacing_ = image.meanRowSpacing();
  knowledge_.resize(heights.size());
  for (std::size_t v = 0; v < heights.size(); ++v)
    knowledge_[v] = std::isnan(heights[v]) ? Assumed : Given;
  for (int round = 0; round < options.reachRounds; ++round)
    carryOnce(sorted, upright, options, heights);
  for (std::size_t v = 0; v < heights.size(); ++v)
    if (knowledge_[v] == Assumed) heights[v] = std::numeric_limits<float>::quiet_NaN();
}

}  // namespace toss
