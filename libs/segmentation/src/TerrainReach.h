// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/TerrainFit.h>

#include <cstdint>
#include <vector>

#include "NodeSorting.h"

namespace toss {

/// Carries the terrain of the coarse field on to where a sensor of few rows meets ground in single
/// rings, metres apart: no plane of a patch follows from a ring, but ground goes on there if most
/// of the returns lie on the surface continued straight on, in a long line, and hardly any under
/// it. (Our addition to spec section 2.4.)
class TerrainReach {
 public:
  /// `field` must outlive this.
  explicit TerrainReach(const TriGridField& field) : field_(field), fit_(field) {}

  /// Whether rows are so far apart that rings leave patches of ground out.
  static bool isNeeded(const RangeImage& image, const GroundOptions& options);

  /// Gives heights to vertices that have none yet, at most a patch further in each round, and fits
  /// all of them. `image`, `sorted`: returns of the scan.
  void carryOn(const RangeImage& image, const NodeSorting& sorted, const UprightNeighbours& upright,
               const GroundOptions& options, VertexHeights& heights);

 private:
  enum Knowledge : std::uint8_t { Assumed, Supported, Given };

  void carryOnce(const NodeSorting& sorted, const UprightNeighbours& upright,
                 const GroundOptions& options, VertexHeights& heights);
  /// How many vertices of a node are known at least so well.
  int verticesWith(Knowledge least, int node) const;
  bool isGround(int node, const NodePoints& points, const GroundOptions& options,
                const VertexHeights& heights) const;

  const TriGridField& field_;
  TerrainFit fit_;
  /// Angle between rows of the scan [rad].
  float rowSpacing_ = 0.0f;
  /// What is known of each vertex, shape [vertices].
  std::vector<Knowledge> knowledge_;
};

}  // namespace toss
