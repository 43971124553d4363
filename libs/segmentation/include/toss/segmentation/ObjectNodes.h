// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/LinkRules.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// LinkRules::Reach::window of each node, shape [nodes].
using NodeWindows = std::vector<std::int32_t>;

/// All nodes of a scan, row by row from the top and by column within a row: a node is one surface
/// seen in one pixel, and what is clustered. Returns of a pixel that lie on one surface share a
/// node, so every return above ground is a node or a mate of one. Struct of arrays.
struct ObjectNodes {
  /// Coordinates in the level frame [m], and horizontal distance from the sensor [m].
  struct Place {
    float x, y, z, range;
  };
  /// Shape [nodes].
  std::vector<Place> places;
  /// The same for those who go through all nodes, shape [nodes].
  std::vector<float> x, y, range;
  /// Column in the range image, index of the point that stands for the node, and number of returns
  /// that share it, shape [nodes].
  std::vector<std::int32_t> column, point, returns;
  NodeWindows windows;
  /// Nodes of row r are rowBegin[r] .. rowBegin[r + 1] - 1, shape [rows + 1].
  std::vector<std::int32_t> rowBegin;
  /// 1 for returns that are nodes or mates, else 0, shape [returns, and zeros up to full blocks of
  /// visitMarks()].
  std::vector<std::uint8_t> isAbove;
  /// 1 for pixels with such returns, row by row, each with zeros up to full blocks.
  std::vector<std::uint8_t> pixelMarks;
  /// Returns that are mates, and the node of each, shape [mates].
  std::vector<std::int32_t> matePoint, mateNode;

  std::size_t size() const { return point.size(); }
  int rows() const { return static_cast<int>(rowBegin.size()) - 1; }
};

/// Fills `result` with the Unclustered points of the image. `pixelMerge` [m]: a return joins the
/// first node of its pixel whose range differs by less than this.
void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& result);

/// Windows for link distances times `factor`.
void shortenWindows(const NodeWindows& windows, float factor, NodeWindows& result);

}  // namespace toss
