// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/TerrainFit.h>
#include <toss/segmentation/TraversabilitySearch.h>

#include <cmath>
#include <limits>

#include "NodeSorting.h"

namespace toss {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
/// Distance from the surface up to which returns take part in the first and in later rounds [m]:
/// the planes of whole triangles are off by more than the model that replaces them.
constexpr float kFirstGate = 0.4f, kGate = 0.2f;

}  // namespace

struct GroundSegmentation::Implementation {
  explicit Implementation(const GroundOptions& given)
      : options(given),
        subdivision(given.refine && given.terrainRounds > 0 ? given.subdivision : 1),
        field(given.extent, given.cellSize),
        fineField(field.refined(subdivision)),
        nodes(static_cast<std::size_t>(field.nodes())),
        fineNodes(static_cast<std::size_t>(fineField.nodes())),
        sorted(field, fineField, subdivision),
        terrain(fineField) {}

  void fitNodes();
  void fitTerrain();
  void copyToFine();
  void labelPoints(Segmentation& segmentation) const;
  PointClass classOf(float height, float x, float y, float z, const GroundNode& node) const;

  GroundOptions options;
  int subdivision;
  TriGridField field, fineField;
  std::vector<GroundNode> nodes, fineNodes;
  NodeSorting sorted;
  TerrainFit terrain;
  VertexHeights heights, fineHeights;
};

void GroundSegmentation::Implementation::fitNodes() {
  for (int node = 0; node < field.nodes(); ++node) {
    nodes[static_cast<std::size_t>(node)] = fitGroundNode(sorted.ofCoarse(node), options);
  }
}

/// Heights of the fine vertices on the coarse planes: the start of the fit.
void GroundSegmentation::Implementation::copyToFine() {
  fineHeights.assign(static_cast<std::size_t>(fineField.vertices()), kUnknown);
  for (int place = 0; place < sorted.places(); ++place) {
    const GroundNode& node = nodes[static_cast<std::size_t>(place / sorted.finePerCoarse())];
    if (!node.isGround()) continue;
    for (const int vertex : fineField.verticesOf(sorted.fineAtPlace(place))) {
      const Eigen::Vector2f q = fineField.vertexPosition(vertex);
      fineHeights[static_cast<std::size_t>(vertex)] =
          -(node.normal.head<2>().dot(q) + node.offset) / node.normal.z();
    }
  }
}

void GroundSegmentation::Implementation::fitTerrain() {
  copyToFine();
  for (int round = 0; round < options.terrainRounds; ++round) {
    const float gate = round == 0 ? kFirstGate : kGate;
    terrain.extend(fineHeights);
    terrain.clear();
    for (int place = 0; place < sorted.places(); ++place) {
      terrain.add(sorted.fineAtPlace(place), sorted.atPlace(place), fineHeights, gate);
    }
    terrain.solve(fineHeights);
  }
  for (int place = 0; place < sorted.places(); ++place) {
    const int index = sorted.fineAtPlace(place);
    GroundNode& node = fineNodes[static_cast<std::size_t>(index)];
    node.type = NodeType::Unknown;
    if (sorted.atPlace(place).count == 0) continue;
    replacePlane(fineField, options, fineHeights, index, node);
  }
}

PointClass GroundSegmentation::Implementation::classOf(float height, float x, float y, float z,
                                                       const GroundNode& node) const {
  if (!(height < static_cast<float>(options.groundHeight))) return PointClass::Unclustered;
  if (height >= -static_cast<float>(options.outlierDepth)) return PointClass::Ground;
  // A plane that is seen from underneath is no ground that could hide anything.
  if (node.offset <= 0.0f) return PointClass::Unclustered;
  // Length of the beam's last part that runs under the plane; the sensor is `offset` above it.
  const float under = std::sqrt(x * x + y * y + z * z) * height / (height - node.offset);
  return under >= static_cast<float>(options.minBuriedPath) ? PointClass::BelowGround
                                                            : PointClass::Unclustered;
}

void GroundSegmentation::Implementation::labelPoints(Segmentation& segmentation) const {
  for (int place = 0; place < sorted.places(); ++place) {
    const GroundNode& node = fineNodes[static_cast<std::size_t>(sorted.fineAtPlace(place))];
    if (!node.isGround()) continue;
    const NodePoints points = sorted.atPlace(place);
    const std::int32_t* const original = sorted.originalAtPlace(place);
    for (std::size_t i = 0; i < points.count; ++i) {
      const float x = points.x[i], y = points.y[i], z = points.z[i];
      const float height = node.heightOf(x, y, z);
      const auto point = static_cast<std::size_t>(original[i]);
      segmentation.heightAboveGround[point] = height;
      segmentation.pointClass[point] = classOf(height, x, y, z, node);
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
  segmentation.heightAboveGround.assign(points.x.size(), kUnknown);
  stage.sorted.sort(points, segmentation.pointClass);
  stage.fitNodes();
  searchTraversable(stage.field, stage.options, stage.nodes);
  if (stage.options.refine) {
    averageVertices(stage.field, stage.nodes, stage.heights);
    replacePlanes(stage.field, stage.options, stage.heights, stage.nodes);
  }
  if (stage.options.refine && stage.options.terrainRounds > 0) {
    stage.fitTerrain();
  } else {
    stage.fineNodes = stage.nodes;
  }
  stage.labelPoints(segmentation);
}

const TriGridField& GroundSegmentation::field() const {
  return implementation_->fineField;
}
const std::vector<GroundNode>& GroundSegmentation::nodes() const {
  return implementation_->fineNodes;
}

}  // namespace toss
