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

/// The surfaces that are clustered, row by row from the top and by column within a row: one node
/// per pixel and surface seen in it. Returns of a pixel that lie on one surface share a node, so
/// every return above ground is a node or a mate of one.
struct ObjectNodes {
  /// Point index of the node's nearest return, shape [nodes] as all up to `returns`.
  std::vector<std::int32_t> point;
  std::vector<std::uint16_t> column;
  /// Coordinates in the level frame [m], and horizontal distance from the sensor [m].
  std::vector<float> x, y, z, range;
  /// LinkRules::Reach of the node [m, m, columns].
  std::vector<float> horizontal, vertical;
  std::vector<std::int32_t> window;
  /// Number of returns that share the node.
  std::vector<std::int32_t> returns;
  /// Nodes of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// Returns that are mates, and the node of each, shape [mates].
  std::vector<std::int32_t> matePoint, mateNode;

  std::size_t size() const { return point.size(); }
  int rows() const { return static_cast<int>(rowBegin.size()) - 1; }
  /// Whether a and b, `columnGap` columns apart, lie within the link distance and window of each.
  /// `distance`: `horizontal` or `vertical`.
  bool linked(const std::vector<float>& distance, std::size_t a, std::size_t b,
              std::int32_t columnGap) const {
    const float limit = std::min(distance[a], distance[b]);
    const float dx = x[a] - x[b], dy = y[a] - y[b];
    return dx * dx + dy * dy < limit * limit && columnGap <= std::min(window[a], window[b]);
  }
  void clear();
};

/// Fills `nodes` with the Unclustered points of the image. `pixelMerge` [m]: a return joins
/// the first node of its pixel whose range differs by less than this.
void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& nodes);

/// Copies the nodes whose `selected` is not 0, link distances times `factor`, without mates.
/// `source`: index in `nodes` of each copied node.
void selectNodes(const ObjectNodes& nodes, const std::vector<std::uint8_t>& selected, float factor,
                 ObjectNodes& result, std::vector<std::int32_t>& source);

}  // namespace toss
