// SPDX-License-Identifier: BSD-3-Clause
#include "NodeSorting.h"

#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/TerrainRefinement.h>
#include <toss/segmentation/TraversabilitySearch.h>

#include <limits>

namespace toss {

struct GroundSegmentation::Implementation {
  explicit Implementation(const GroundOptions& given)
      : options(given),
        field(given.extent, given.cellSize),
        nodes(static_cast<std::size_t>(field.nodes())) {}

  void fitNodes() {
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      nodes[node] = fitGroundNode(sorted.pointsOf(node), options);
    }
  }

  void refineTerrain() {
    averageVertices(field, nodes, heights);
    replacePlanes(field, options, heights, nodes);
  }

  void labelPoints(Segmentation& segmentation) const;

  GroundOptions options;
  TriGridField field;
  std::vector<GroundNode> nodes;
  NodeSorting sorted;
  VertexHeights heights;
};

void GroundSegmentation::Implementation::labelPoints(Segmentation& segmentation) const {
  const auto above = static_cast<float>(options.groundHeight);
  const auto below = -static_cast<float>(options.outlierDepth);
  for (std::size_t index = 0; index < nodes.size(); ++index) {
    const GroundNode& node = nodes[index];
    if (!node.isGround()) continue;
    const NodePoints points = sorted.pointsOf(index);
    const std::int32_t* const original = sorted.originalOf(index);
    for (std::size_t i = 0; i < points.count; ++i) {
      const float height = node.heightOf(points.x[i], points.y[i], points.z[i]);
      const auto point = static_cast<std::size_t>(original[i]);
      segmentation.heightAboveGround[point] = height;
      if (!(height < above)) continue;
      segmentation.pointClass[point] = height < below ? PointClass::BelowGround : PointClass::Ground;
    }
  }
}

GroundSegmentation::GroundSegmentation(const GroundOptions& options) {
  options.check();
  implementation_ = std::make_unique<Implementation>(options);
}
GroundSegmentation::~GroundSegmentation() = default;
GroundSegmentation::GroundSegmentation(GroundSegmentation&&) noexcept = default;

void GroundSegmentation::segment(const LevelPoints& points, const RangeImage&,
                                 Segmentation& segmentation) {
  Implementation& stage = *implementation_;
  segmentation.heightAboveGround.assign(points.x.size(), std::numeric_limits<float>::quiet_NaN());
  stage.sorted.sort(points, segmentation.pointClass, stage.field);
  stage.fitNodes();
  searchTraversable(stage.field, stage.options, stage.nodes);
  if (stage.options.refine) stage.refineTerrain();
  stage.labelPoints(segmentation);
}

const TriGridField& GroundSegmentation::field() const { return implementation_->field; }
const std::vector<GroundNode>& GroundSegmentation::nodes() const { return implementation_->nodes; }

}  // namespace toss
