// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ContactPoints.h>
#include <toss/segmentation/GroundNodeFit.h>
#include <toss/segmentation/GroundSegmentation.h>
#include <toss/segmentation/TerrainFit.h>
#include <toss/segmentation/TraversabilitySearch.h>
#include <toss/segmentation/UprightNeighbours.h>

#include <limits>

#include "GroundLabeling.h"
#include "NodeSorting.h"
#include "TerrainReach.h"

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
        nodeFit(given),
        reach(field),
        terrain(fineField) {}

  void fitNodes();
  void fitTerrain(const UprightNeighbours& upright);
  void copyToFine();

  GroundOptions options;
  int subdivision;
  TriGridField field, fineField;
  std::vector<GroundNode> nodes, fineNodes;
  NodeSorting sorted;
  GroundNodeFit nodeFit;
  TerrainReach reach;
  TerrainFit terrain;
  GroundLabeling labeling;
  ContactPoints contacts;
  VertexHeights heights, fineHeights;
};

void GroundSegmentation::Implementation::fitNodes() {
  for (int node = 0; node < field.nodes(); ++node) {
    nodes[static_cast<std::size_t>(node)] = nodeFit.fit(sorted.ofCoarse(node));
  }
}

/// Heights of the fine vertices on the coarse planes: the start of the fit.
void GroundSegmentation::Implementation::copyToFine() {
  fineHeights.assign(static_cast<std::size_t>(fineField.vertices()), kUnknown);
  for (int index = 0; index < field.nodes(); ++index) {
    const GroundNode& node = nodes[static_cast<std::size_t>(index)];
    if (!node.isGround()) continue;
    const int first = index * sorted.finePerCoarse();
    for (int place = first; place < first + sorted.finePerCoarse(); ++place) {
      for (const int vertex : fineField.verticesOf(sorted.fineAtPlace(place))) {
        const Eigen::Vector2f q = fineField.vertexPosition(vertex);
        fineHeights[static_cast<std::size_t>(vertex)] = node.planeHeight(q.x(), q.y());
      }
    }
  }
}

void GroundSegmentation::Implementation::fitTerrain(const UprightNeighbours& upright) {
  copyToFine();
  for (int round = 0; round < options.terrainRounds; ++round) {
    const float gate = round == 0 ? kFirstGate : kGate;
    terrain.extend(fineHeights);
    terrain.clear();
    for (const int place : sorted.occupied()) {
      terrain.add(sorted.fineAtPlace(place), sorted.atPlace(place), fineHeights, gate, &upright);
    }
    terrain.solve(fineHeights);
  }
  for (GroundNode& node : fineNodes) node.type = NodeType::Unknown;
  for (const int place : sorted.occupied()) {
    const int index = sorted.fineAtPlace(place);
    replacePlane(fineField, options, fineHeights, index,
                 fineNodes[static_cast<std::size_t>(index)]);
  }
}

GroundSegmentation::GroundSegmentation(const GroundOptions& options) {
  options.check();
  implementation_ = std::make_unique<Implementation>(options);
}
GroundSegmentation::~GroundSegmentation() = default;
GroundSegmentation::GroundSegmentation(GroundSegmentation&&) noexcept = default;

void GroundSegmentation::segment(const LevelPoints& points, const RangeImage& image,
                                 Segmentation& segmentation) {
  Implementation& stage = *implementation_;
  stage.sorted.sort(points, segmentation.pointClass);
  stage.fitNodes();
  searchTraversable(stage.field, stage.options, stage.nodes);
  const UprightNeighbours upright(points, image, static_cast<float>(stage.options.contactSlope));
  const bool fits = stage.options.refine && stage.options.terrainRounds > 0;
  if (stage.options.refine) {
    averageVertices(stage.field, stage.nodes, stage.heights);
    if (fits && TerrainReach::isNeeded(image, stage.options))
      stage.reach.carryOn(image, stage.sorted, upright, stage.options, stage.heights);
    replacePlanes(stage.field, stage.options, stage.heights, stage.nodes);
  }
  if (fits) {
    stage.fitTerrain(upright);
  } else {
    stage.fineNodes = stage.nodes;
  }
  stage.labeling.label(points, stage.sorted, stage.fineField, stage.fineNodes, stage.options,
                       segmentation);
  segmentation.nearbyGround.assign(stage.fineField, stage.fineNodes);
  stage.contacts.release(points, image, stage.options, segmentation);
}

const TriGridField& GroundSegmentation::field() const {
  return implementation_->fineField;
}
const std::vector<GroundNode>& GroundSegmentation::nodes() const {
  return implementation_->fineNodes;
}

}  // namespace toss
