// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// One surface seen in one pixel: what is clustered.
struct ObjectNode {
  /// Coordinates in the level frame [m], and horizontal distance from the sensor [m].
  float x, y, z, range;
  /// LinkRules::Reach of the node.
  LinkRules::Reach reach;
  std::int32_t column;
  /// Index of the point that stands for the node, and number of returns that share it.
  std::int32_t point, returns;
};

/// Whether a and b, `columnGap` columns apart, lie within the link distance and window of each.
/// `distance`: which link distance, horizontal or vertical.
inline bool linked(const ObjectNode& a, const ObjectNode& b, float LinkRules::Reach::*distance,
                   std::int32_t columnGap) {
  const float limit = std::min(a.reach.*distance, b.reach.*distance);
  const float dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy < limit * limit && columnGap <= std::min(a.reach.window, b.reach.window);
}

/// All nodes of a scan, row by row from the top and by column within a row. Returns of a pixel that
/// lie on one surface share a node, so every return above ground is a node or a mate of one.
struct ObjectNodes {
  /// Shape [nodes].
  std::vector<ObjectNode> nodes;
  /// Nodes of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Returns that are mates, and the node of each, shape [mates].
  std::vector<std::int32_t> matePoint, mateNode;

  std::size_t size() const { return nodes.size(); }
  const ObjectNode& operator[](std::size_t i) const { return nodes[i]; }
  int rows() const { return static_cast<int>(rowBegin.size()) - 1; }
};

/// Fills `result` with the Unclustered points of the image. `pixelMerge` [m]: a return joins the
/// first node of its pixel whose range differs by less than this.
void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& result);

/// Copies the nodes whose `selected` is not 0, link distances times `factor`, without mates.
/// `source`: index in `nodes` of each copied node.
void selectNodes(const ObjectNodes& nodes, const std::vector<std::uint8_t>& selected, float factor,
                 ObjectNodes& result, std::vector<std::int32_t>& source);

}  // namespace toss
