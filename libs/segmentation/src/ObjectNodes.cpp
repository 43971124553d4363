// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ObjectNodes.h>

#include <cmath>

namespace toss {
namespace {

/// What gathering reads.
struct Scan {
  const LevelPoints& points;
  const RangeImage& image;
  const Segmentation& segmentation;
};

bool isCandidate(const Scan& scan, std::size_t i) {
  return scan.segmentation.pointClass[i] == PointClass::Unclustered &&
         scan.image.row[i] != RangeImage::kNoRow && std::isfinite(scan.points.x[i]) &&
         std::isfinite(scan.points.y[i]) && std::isfinite(scan.points.z[i]);
}

ObjectNode makeNode(const Scan& scan, const LinkRules& rules, std::int32_t point, int column) {
  const std::size_t i = static_cast<std::size_t>(point);
  const float x = scan.points.x[i], y = scan.points.y[i];
  const float range = std::sqrt(x * x + y * y);
  return {x, y, scan.points.z[i], range, rules.reach(range), column, point, 1};
}

/// Node `first` or later, all of one pixel, on whose surface a return at `range` lies; -1 if none.
std::int32_t surfaceAt(const RangeImage& image, const std::vector<ObjectNode>& nodes,
                       std::size_t first, float range, float pixelMerge) {
  for (std::size_t n = first; n < nodes.size(); ++n) {
    const float surface = image.range[static_cast<std::size_t>(nodes[n].point)];
    if (std::abs(range - surface) < pixelMerge) return static_cast<std::int32_t>(n);
  }
  return -1;
}

/// Adds the returns of a pixel: it may hold several surfaces, the edge of one and what is behind.
void gatherPixel(const Scan& scan, const LinkRules& rules, float pixelMerge, int column,
                 std::int32_t head, ObjectNodes& result) {
  const std::size_t first = result.size();
  for (std::int32_t p = head; p != RangeImage::kNone;
       p = scan.image.next[static_cast<std::size_t>(p)]) {
    const std::size_t i = static_cast<std::size_t>(p);
    if (!isCandidate(scan, i)) continue;
    const std::int32_t host =
        surfaceAt(scan.image, result.nodes, first, scan.image.range[i], pixelMerge);
    if (host < 0) {
      result.nodes.push_back(makeNode(scan, rules, p, column));
      continue;
    }
    result.matePoint.push_back(p);
    result.mateNode.push_back(host);
    ++result.nodes[static_cast<std::size_t>(host)].returns;
  }
}

void shorten(LinkRules::Reach& reach, float factor) {
  reach.horizontal *= factor;
  reach.vertical *= factor;
  // One column of the window is for returns that lie anywhere in their pixels, whatever the reach.
  const float columns = std::ceil(factor * static_cast<float>(reach.window - 1));
  reach.window = std::min(reach.window, static_cast<std::int32_t>(columns) + 1);
}

void clear(ObjectNodes& nodes) {
  nodes.nodes.clear();
  nodes.rowBegin.assign(1, 0);
  nodes.matePoint.clear(), nodes.mateNode.clear();
}

}  // namespace

void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& result) {
  clear(result);
  const Scan scan{points, image, segmentation};
  for (int row = 0; row < image.rows; ++row) {
    const std::int32_t* const heads = image.representative.data() + image.pixel(row, 0);
    for (int column = 0; column < image.columns; ++column) {
      if (heads[column] == RangeImage::kNone) continue;
      gatherPixel(scan, rules, pixelMerge, column, heads[column], result);
    }
    result.rowBegin.push_back(static_cast<std::int32_t>(result.size()));
  }
}

void selectNodes(const ObjectNodes& nodes, const std::vector<std::uint8_t>& selected, float factor,
                 ObjectNodes& result, std::vector<std::int32_t>& source) {
  clear(result);
  source.clear();
  for (std::size_t row = 0; row + 1 < nodes.rowBegin.size(); ++row) {
    for (std::int32_t n = nodes.rowBegin[row]; n < nodes.rowBegin[row + 1]; ++n) {
      if (!selected[static_cast<std::size_t>(n)]) continue;
      source.push_back(n);
      result.nodes.push_back(nodes[static_cast<std::size_t>(n)]);
      shorten(result.nodes.back().reach, factor);
    }
    result.rowBegin.push_back(static_cast<std::int32_t>(result.size()));
  }
}

}  // namespace toss
