// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/MarkedWords.h>
#include <toss/geometry/ProcessorVariants.h>
#include <toss/segmentation/ObjectNodes.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// What gathering reads.
struct Scan {
  const RangeImage& image;
  /// ObjectNodes::isAbove.
  const std::uint8_t* isAbove;
  float pixelMerge;
};

/// Nodes as they are added; there is room for all.
struct NodeList {
  std::int32_t *point, *column;
  std::size_t count = 0;

  void add(std::int32_t newPoint, int newColumn) {
    point[count] = newPoint, column[count] = newColumn;
    ++count;
  }
};

/// Node `first` or later, all of one pixel, on whose surface a return at `range` lies; -1 if none.
std::int32_t surfaceAt(const RangeImage& image, const NodeList& nodes, std::size_t first,
                       float range, float pixelMerge) {
  for (std::size_t n = first; n < nodes.count; ++n) {
    const float surface = image.range[static_cast<std::size_t>(nodes.point[n])];
    if (std::abs(range - surface) < pixelMerge) return static_cast<std::int32_t>(n);
  }
  return -1;
}

/// Adds the returns of a pixel: it may hold several surfaces, the edge of one and what is behind.
void gatherPixel(const Scan& scan, int column, std::int32_t head, NodeList& nodes,
                 ObjectNodes& result) {
  const std::size_t first = nodes.count;
  for (std::int32_t p = head; p != RangeImage::kNone;
       p = scan.image.next[static_cast<std::size_t>(p)]) {
    const std::size_t i = static_cast<std::size_t>(p);
    if (scan.isAbove[i] == 0) continue;
    const std::int32_t host =
        surfaceAt(scan.image, nodes, first, scan.image.range[i], scan.pixelMerge);
    if (host < 0) {
      nodes.add(p, column);
      continue;
    }
    result.matePoint.push_back(p);
    result.mateNode.push_back(host);
  }
}

void gatherRow(const Scan& scan, int row, const std::uint8_t* marks, std::size_t length,
               NodeList& nodes, ObjectNodes& result) {
  const std::int32_t* const heads = scan.image.representative.data() + scan.image.pixel(row, 0);
  const std::int32_t* const next = scan.image.next.data();
  visitMarks(marks, length, [&](std::size_t pixel) {
    const std::int32_t head = heads[pixel];
    const int column = static_cast<int>(pixel);
    if (next[static_cast<std::size_t>(head)] == RangeImage::kNone) {
      nodes.add(head, column);
    } else {
      gatherPixel(scan, column, head, nodes, result);
    }
  });
}

TOSS_ALSO_FOR_AVX2
void findAbove(const PointClass* __restrict pointClass, const std::uint16_t* __restrict row,
               std::size_t n, std::uint8_t* __restrict isAbove) {
  for (std::size_t i = 0; i < n; ++i) {
    isAbove[i] = static_cast<std::uint8_t>((pointClass[i] == PointClass::Unclustered) &
                                           (row[i] != RangeImage::kNoRow));
  }
}

/// Marks the returns above ground and their pixels, `rowLength` marks per row. Returns how many
/// there are.
std::size_t markAbove(const RangeImage& image, const Segmentation& segmentation,
                      std::size_t rowLength, ObjectNodes& nodes) {
  const std::size_t n = image.row.size();
  nodes.isAbove.resize(roundedToBlocks(n));
  std::fill(nodes.isAbove.begin() + static_cast<std::ptrdiff_t>(n), nodes.isAbove.end(),
            std::uint8_t{0});
  findAbove(segmentation.pointClass.data(), image.row.data(), n, nodes.isAbove.data());
  nodes.pixelMarks.assign(static_cast<std::size_t>(image.rows) * rowLength, 0);
  std::size_t count = 0;
  visitMarks(nodes.isAbove.data(), nodes.isAbove.size(), [&](std::size_t i) {
    nodes.pixelMarks[image.row[i] * rowLength + image.column[i]] = 1;
    ++count;
  });
  return count;
}

void clear(ObjectNodes& nodes) {
  nodes.rowBegin.assign(1, 0);
  nodes.matePoint.clear(), nodes.mateNode.clear();
}

void countReturns(ObjectNodes& nodes) {
  nodes.returns.assign(nodes.size(), 1);
  for (const std::int32_t node : nodes.mateNode) ++nodes.returns[static_cast<std::size_t>(node)];
}

void takePlaces(const LevelPoints& points, ObjectNodes& nodes) {
  const std::size_t n = nodes.size();
  nodes.places.resize(n);
  nodes.x.resize(n), nodes.y.resize(n), nodes.range.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto point = static_cast<std::size_t>(nodes.point[i]);
    const float x = points.x[point], y = points.y[point];
    const float range = std::sqrt(x * x + y * y);
    nodes.places[i] = {x, y, points.z[point], range};
    nodes.x[i] = x, nodes.y[i] = y, nodes.range[i] = range;
  }
}

// The compiler vectorises these only as functions of arrays that are known not to overlap.

TOSS_ALSO_FOR_AVX2
void findWindows(const LinkRules& rules, const float* __restrict range, std::size_t n,
                 std::int32_t* __restrict window) {
  const LinkRules held = rules;
  for (std::size_t i = 0; i < n; ++i) window[i] = held.reach(range[i]).window;
}

/// One column of a window is for returns that lie anywhere in their pixels, whatever the reach.
TOSS_ALSO_FOR_AVX2
void shortenAll(const std::int32_t* __restrict window, std::size_t n, float factor,
                std::int32_t* __restrict result) {
  for (std::size_t i = 0; i < n; ++i) {
    const float columns = factor * static_cast<float>(window[i] - 1);
    const auto whole = static_cast<std::int32_t>(columns);
    const std::int32_t roundedUp = whole + (static_cast<float>(whole) < columns ? 1 : 0);
    result[i] = std::min(window[i], roundedUp + 1);
  }
}

}  // namespace

void gatherNodes(const LevelPoints& points, const RangeImage& image,
                 const Segmentation& segmentation, const LinkRules& rules, float pixelMerge,
                 ObjectNodes& result) {
  clear(result);
  const std::size_t rowLength = roundedToBlocks(static_cast<std::size_t>(image.columns));
  const std::size_t most = markAbove(image, segmentation, rowLength, result);
  result.point.resize(most), result.column.resize(most);
  const Scan scan{image, result.isAbove.data(), pixelMerge};
  NodeList nodes{result.point.data(), result.column.data()};
  for (int row = 0; row < image.rows; ++row) {
    const std::uint8_t* const marks =
        result.pixelMarks.data() + static_cast<std::size_t>(row) * rowLength;
    gatherRow(scan, row, marks, rowLength, nodes, result);
    result.rowBegin.push_back(static_cast<std::int32_t>(nodes.count));
  }
  const std::size_t n = nodes.count;
  result.point.resize(n), result.column.resize(n);
  countReturns(result);
  takePlaces(points, result);
  result.windows.resize(n);
  findWindows(rules, result.range.data(), n, result.windows.data());
}

void shortenWindows(const NodeWindows& windows, float factor, NodeWindows& result) {
  result.resize(windows.size());
  shortenAll(windows.data(), windows.size(), factor, result.data());
}

}  // namespace toss
