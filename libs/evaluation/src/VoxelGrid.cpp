// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/NearestNeighbors.h>
#include <toss/evaluation/VoxelGrid.h>

#include <numeric>

namespace toss {
namespace {

float meanOf(const std::vector<float>& values, std::uint32_t first, std::uint32_t end) {
  double sum = 0.0;
  for (std::uint32_t i = first; i < end; ++i) sum += static_cast<double>(values[i]);
  return static_cast<float>(sum / static_cast<double>(end - first));
}

/// One point per cell, at the centroid of the cell's points.
CellOrder centroidsOf(const CellOrder& order) {
  CellOrder centroids;
  const std::size_t n = order.cells();
  centroids.key = order.key;
  centroids.index.resize(n);
  std::iota(centroids.index.begin(), centroids.index.end(), 0u);
  centroids.begin = centroids.index;
  centroids.begin.push_back(static_cast<std::uint32_t>(n));
  for (std::size_t cell = 0; cell < n; ++cell) {
    const std::uint32_t first = order.begin[cell], end = order.begin[cell + 1];
    centroids.x.push_back(meanOf(order.x, first, end));
    centroids.y.push_back(meanOf(order.y, first, end));
    centroids.z.push_back(meanOf(order.z, first, end));
  }
  return centroids;
}

}  // namespace

void voxelize(const CellOrder& order, const std::vector<std::uint32_t>& label, double voxelSize,
              LabelledCloud& result, std::vector<CellKey>* keys) {
  CellOrder centroids = centroidsOf(order);
  // The nearest point of a centroid's own cell is at most half a cell's diagonal away (root mean
  // square of distances to a mean), so the nearest of all lies within one cell size.
  const auto nearest = nearestNeighbors(centroids, order, voxelSize, centroids.places());
  result.label.resize(order.cells());
  for (std::size_t i = 0; i < order.cells(); ++i) {
    result.label[i] = label[static_cast<std::size_t>(nearest[i])];
  }
  result.x = std::move(centroids.x), result.y = std::move(centroids.y);
  result.z = std::move(centroids.z);
  if (keys) *keys = std::move(centroids.key);
}

LabelledCloud voxelize(const LabelledCloud& cloud, double voxelSize) {
  CellOrder order;
  orderByCell(cloud, voxelSize, order);
  LabelledCloud result;
  voxelize(order, cloud.label, voxelSize, result);
  return result;
}

}  // namespace toss
