// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ObjectNodes.h>

#include <cmath>

namespace toss {
namespace {

bool isCandidate(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, std::size_t i) {
  return segmentation.pointClass[i] == PointClass::Unclustered &&
         image.row[i] != RangeImage::kNoRow && std::isfinite(points.x[i]) &&
         std::isfinite(points.y[i]) && std::isfinite(points.z[i]);
}

void addNode(const LevelPoints& points, const LinkRules& rules, std::size_t i, int column,
             ObjectNodes& nodes) {
  const float range = std::sqrt(points.x[i] * points.x[i] + points.y[i] * points.y[i]);
  const LinkRules::Reach reach = rules.reach(range);
  nodes.point.push_back(static_cast<std::int32_t>(i));
  nodes.column.push_back(static_cast<std::uint16_t>(column));
  nodes.x.push_back(points.x[i]);
  nodes.y.push_back(points.y[i]);
  nodes.z.push_back(points.z[i]);
  nodes.range.push_back(range);
  nodes.horizontal.push_back(reach.horizontal);
  nodes.vertical.push_back(reach.vertical);
  nodes.window.push_back(reach.window);
  nodes.returns.push_back(1);
}

/// Node `first` or later, all of one pixel, on whose surface a return at `range` lies; -1 if none.
std::int32_t surfaceAt(const RangeImage& image, const ObjectNodes& nodes, std::size_t first,
                       float range, float pixelMerge) {
  for (std::size_t n = first; n < nodes.size(); ++n) {
    const float surface = image.range[static_cast<std::size_t>(nodes.point[n])];
    if (std::abs(range - surface) < pixelMerge) return static_cast<std::int32_t>(n);
  }
  return -1;
}

/// Adds the returns of a pixel: it may hold several surfaces, the edge of one and what is behind.
void gatherPixel(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 int row, int column, ObjectNodes& nodes) {
  const std::size_t first = nodes.size();
  for (std::int32_t p = image.at(row, column); p != RangeImage::kNone;
       p = image.next[static_cast<std::size_t>(p)]) {
    const std::size_t i = static_cast<std::size_t>(p);
    if (!isCandidate(points, image, segmentation, i)) continue;
    const std::int32_t host = surfaceAt(image, nodes, first, image.range[i], pixelMerge);
    if (host < 0) {
      addNode(points, rules, i, column, nodes);
      continue;
    }
    nodes.matePoint.push_back(p);
    nodes.mateNode.push_back(host);
    ++nodes.returns[static_cast<std::size_t>(host)];
  }
}

}  // namespace

void ObjectNodes::clear() {
  point.clear(), column.clear();
  x.clear(), y.clear(), z.clear(), range.clear();
  horizontal.clear(), vertical.clear(), window.clear(), returns.clear();
  rowBegin.clear();
  matePoint.clear(), mateNode.clear();
}

void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& nodes) {
  nodes.clear();
  nodes.rowBegin.push_back(0);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.columns; ++column) {
      gatherPixel(points, image, segmentation, rules, pixelMerge, row, column, nodes);
    }
    nodes.rowBegin.push_back(static_cast<std::int32_t>(nodes.size()));
  }
}

void selectNodes(const ObjectNodes& nodes, const std::vector<std::uint8_t>& selected, float factor,
                 ObjectNodes& result, std::vector<std::int32_t>& source) {
  result.clear();
  source.clear();
  result.rowBegin.push_back(0);
  for (int row = 0; row < nodes.rows(); ++row) {
    const std::size_t r = static_cast<std::size_t>(row);
    for (std::int32_t n = nodes.rowBegin[r]; n < nodes.rowBegin[r + 1]; ++n) {
      const std::size_t i = static_cast<std::size_t>(n);
      if (!selected[i]) continue;
      source.push_back(n);
      result.point.push_back(nodes.point[i]);
      result.column.push_back(nodes.column[i]);
      result.x.push_back(nodes.x[i]);
      result.y.push_back(nodes.y[i]);
      result.z.push_back(nodes.z[i]);
      result.range.push_back(nodes.range[i]);
      result.horizontal.push_back(factor * nodes.horizontal[i]);
      result.vertical.push_back(factor * nodes.vertical[i]);
      result.window.push_back(nodes.window[i]);
      result.returns.push_back(nodes.returns[i]);
    }
    result.rowBegin.push_back(static_cast<std::int32_t>(result.size()));
  }
}

}  // namespace toss
