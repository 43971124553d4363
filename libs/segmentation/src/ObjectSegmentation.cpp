// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/MarkedWords.h>
#include <toss/segmentation/LargeComponentSplit.h>
#include <toss/segmentation/LeftoverPoints.h>
#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/NodeClustering.h>
#include <toss/segmentation/ObjectNodes.h>
#include <toss/segmentation/ObjectSegmentation.h>

#include <stdexcept>

namespace toss {
namespace {

void checkSizes(const LevelPoints& points, const RangeImage& image,
                const Segmentation& segmentation) {
  const std::size_t n = segmentation.pointClass.size();
  const std::size_t pixels =
      static_cast<std::size_t>(image.rows) * static_cast<std::size_t>(image.columns);
  if (points.x.size() != n || points.y.size() != n || points.z.size() != n ||
      image.row.size() != n || image.column.size() != n || image.next.size() != n ||
      image.range.size() != n || image.representative.size() != pixels) {
    throw std::logic_error(
        "ObjectSegmentation: points, range image and segmentation differ in size");
  }
}

}  // namespace

struct ObjectSegmentation::Implementation {
  explicit Implementation(const ObjectOptions& o)
      : options(o),
        splitter(static_cast<float>(o.splitExtent), static_cast<float>(o.splitFactor)) {}

  /// Numbers the components that are instances; returns how many.
  std::int32_t numberInstances(const LinkRules& rules);
  void write(Segmentation& segmentation);
  /// Groups the points by instance.
  void fillMembers(Segmentation& segmentation) const;

  ObjectOptions options;
  ObjectNodes nodes;
  NodeClustering clustering;
  LargeComponentSplit splitter;
  NodeComponents components;
  std::vector<std::int32_t> instanceOfComponent, instanceOfNode;
  /// Nodes in no instance.
  std::vector<NodeComponents::Piece> leftover;
};

std::int32_t ObjectSegmentation::Implementation::numberInstances(const LinkRules& rules) {
  instanceOfComponent.resize(components.measures.size());
  std::int32_t count = 0;
  for (std::size_t c = 0; c < instanceOfComponent.size(); ++c) {
    const Component& component = components.measures[c];
    const bool enough = component.returns >= rules.minPoints(component.nearest);
    const bool tooMany = options.maxPoints > 0 && component.returns > options.maxPoints;
    instanceOfComponent[c] = enough && !tooMany ? ++count : 0;
  }
  return count;
}

void ObjectSegmentation::Implementation::write(Segmentation& segmentation) {
  const auto give = [&](std::int32_t point, std::int32_t instance) {
    segmentation.instance[static_cast<std::size_t>(point)] = instance;
    segmentation.pointClass[static_cast<std::size_t>(point)] =
        instance == 0 ? PointClass::Unclustered : PointClass::Instance;
  };
  instanceOfNode.resize(nodes.size());
  leftover.clear();
  for (const NodeComponents::Piece& piece : components.pieces) {
    const std::int32_t instance = instanceOfComponent[static_cast<std::size_t>(piece.component)];
    if (instance == 0) leftover.push_back(piece);
    for (auto i = static_cast<std::size_t>(piece.begin); i < static_cast<std::size_t>(piece.end);
         ++i) {
      instanceOfNode[i] = instance;
      give(nodes.point[i], instance);
    }
  }
  for (std::size_t m = 0; m < nodes.matePoint.size(); ++m) {
    give(nodes.matePoint[m], instanceOfNode[static_cast<std::size_t>(nodes.mateNode[m])]);
  }
}

/// A counting sort, so members ascend within each instance. The returns of nodes have been counted;
/// those that were attached to an instance are of nodes that are in none.
void ObjectSegmentation::Implementation::fillMembers(Segmentation& segmentation) const {
  const std::vector<std::int32_t>& instance = segmentation.instance;
  std::vector<std::int32_t>& begin = segmentation.memberBegin;
  begin.assign(static_cast<std::size_t>(segmentation.instanceCount) + 2, 0);
  const auto instanceOf = [&](std::int32_t point) {
    return static_cast<std::size_t>(instance[static_cast<std::size_t>(point)]);
  };
  for (std::size_t c = 0; c < instanceOfComponent.size(); ++c)
    begin[static_cast<std::size_t>(instanceOfComponent[c]) + 1] = components.measures[c].returns;
  // Slot k + 1 counts instance k.
  begin[1] = 0;
  for (const NodeComponents::Piece& piece : leftover) {
    for (std::int32_t i = piece.begin; i < piece.end; ++i)
      ++begin[instanceOf(nodes.point[static_cast<std::size_t>(i)]) + 1];
  }
  for (std::size_t m = 0; m < nodes.matePoint.size(); ++m) {
    if (instanceOfNode[static_cast<std::size_t>(nodes.mateNode[m])] == 0)
      ++begin[instanceOf(nodes.matePoint[m]) + 1];
  }
  // Those in none come last and are cut off. Summed up, slot k is where k starts, and once filled,
  // where it ends.
  const std::int32_t none = begin[1];
  begin[1] = 0;
  for (std::size_t k = 2; k < begin.size(); ++k) begin[k] += begin[k - 1];
  const std::int32_t count = begin.back();
  begin[0] = count;
  segmentation.members.resize(static_cast<std::size_t>(count + none));
  std::int32_t* const members = segmentation.members.data();
  visitMarks(nodes.isAbove.data(), nodes.isAbove.size(), [&](std::size_t i) {
    members[begin[static_cast<std::size_t>(instance[i])]++] = static_cast<std::int32_t>(i);
  });
  segmentation.members.resize(static_cast<std::size_t>(count));
  begin[0] = 0;
  begin.pop_back();
}

ObjectSegmentation::ObjectSegmentation(const ObjectOptions& options)
    : implementation_((options.check(), std::make_unique<Implementation>(options))) {}
ObjectSegmentation::~ObjectSegmentation() = default;
ObjectSegmentation::ObjectSegmentation(ObjectSegmentation&&) noexcept = default;
ObjectSegmentation& ObjectSegmentation::operator=(ObjectSegmentation&&) noexcept = default;

void ObjectSegmentation::segment(const LevelPoints& points, const RangeImage& image,
                                 Segmentation& segmentation) {
  checkSizes(points, image, segmentation);
  Implementation& self = *implementation_;
  const LinkRules rules(self.options, image);
  gatherNodes(points, image, segmentation, rules, static_cast<float>(self.options.pixelMerge),
              self.nodes);
  self.clustering.cluster(self.nodes, rules);
  self.splitter.split(self.nodes, rules, self.clustering, self.components);
  segmentation.instance.assign(segmentation.pointClass.size(), 0);
  segmentation.instanceCount = self.numberInstances(rules);
  self.write(segmentation);
  if (self.options.attachDistance > 0.0) {
    attachLeftoverPoints(points, image, rules, self.nodes, self.instanceOfNode, self.leftover,
                         static_cast<float>(self.options.attachDistance), segmentation);
  }
  self.fillMembers(segmentation);
}

}  // namespace toss
