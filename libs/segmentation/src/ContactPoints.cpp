// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/ContactPoints.h>
#include <toss/segmentation/UprightNeighbours.h>

#include <vector>

namespace toss {
namespace {

/// Ground returns higher than `height`, by row from the top and in the order of the scan within a
/// row (counting sort).
std::vector<std::int32_t> candidatesByRow(const RangeImage& image, const Segmentation& segmentation,
                                          float height) {
  std::vector<std::int32_t> found(image.row.size());
  std::size_t count = 0;
  // Without branches, as no one could foretell on which side of the height a return lies.
  for (std::size_t point = 0; point < image.row.size(); ++point) {
    found[count] = static_cast<std::int32_t>(point);
    count += static_cast<std::size_t>((segmentation.pointClass[point] == PointClass::Ground) &
                                      (segmentation.heightAboveGround[point] > height));
  }
  found.resize(count);
  std::vector<std::int32_t> begin(static_cast<std::size_t>(image.rows) + 1, 0);
  for (const std::int32_t point : found) {
    ++begin[static_cast<std::size_t>(image.row[static_cast<std::size_t>(point)]) + 1];
  }
  for (std::size_t row = 1; row < begin.size(); ++row) begin[row] += begin[row - 1];
  std::vector<std::int32_t> sorted(found.size());
  for (const std::int32_t point : found) {
    std::int32_t& place = begin[image.row[static_cast<std::size_t>(point)]];
    sorted[static_cast<std::size_t>(place++)] = point;
  }
  return sorted;
}

}  // namespace

void releaseContactPoints(const LevelPoints& points, const RangeImage& image,
                          const GroundOptions& options, Segmentation& segmentation) {
  if (options.contactSlope == 0.0) return;
  const UprightNeighbours neighbours(points, image, static_cast<float>(options.contactSlope));
  const auto isObject = [&](std::size_t point) {
    return segmentation.pointClass[point] == PointClass::Unclustered;
  };
  // From the top, so that what is released carries what lies under it.
  const auto height = static_cast<float>(options.contactHeight);
  for (const std::int32_t candidate : candidatesByRow(image, segmentation, height)) {
    const auto point = static_cast<std::size_t>(candidate);
    if (neighbours.anyAbove(point, isObject)) {
      segmentation.pointClass[point] = PointClass::Unclustered;
    }
  }
}

}  // namespace toss
