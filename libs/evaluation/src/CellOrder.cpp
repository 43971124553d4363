// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/CellOrder.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

constexpr float kReach = static_cast<float>((1 << 20) - 2);

/// Cell of one coordinate, made positive; false where it lies out of reach or is NaN.
bool cellOf(float coordinate, float cellsPerMetre, CellKey& cell) {
  const float floored = std::floor(coordinate * cellsPerMetre);
  if (!(std::abs(floored) < kReach)) return false;
  cell = static_cast<CellKey>(static_cast<std::int64_t>(floored) + (1 << 20));
  return true;
}

struct KeyedPoint {
  CellKey key;
  std::uint32_t index;
};

std::vector<KeyedPoint> keyedPoints(const LabelledCloud& cloud, double cellSize) {
  // The reciprocal in single precision: where PCL's VoxelGrid puts a point on a cell's face.
  const float cellsPerMetre = 1.0f / static_cast<float>(cellSize);
  std::vector<KeyedPoint> keyed;
  keyed.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    CellKey kx, ky, kz;
    if (!cellOf(cloud.x[i], cellsPerMetre, kx) || !cellOf(cloud.y[i], cellsPerMetre, ky) ||
        !cellOf(cloud.z[i], cellsPerMetre, kz)) {
      continue;
    }
    keyed.push_back({kz << 42 | ky << 21 | kx, static_cast<std::uint32_t>(i)});
  }
  return keyed;
}

void clearFor(std::size_t places, CellOrder& result) {
  result.key.clear(), result.begin.clear(), result.index.clear();
  result.x.clear(), result.y.clear(), result.z.clear();
  result.index.reserve(places);
  result.x.reserve(places), result.y.reserve(places), result.z.reserve(places);
}

void addPlace(CellKey key, std::uint32_t index, float x, float y, float z, CellOrder& result) {
  if (result.key.empty() || result.key.back() != key) {
    result.key.push_back(key);
    result.begin.push_back(static_cast<std::uint32_t>(result.index.size()));
  }
  result.index.push_back(index);
  result.x.push_back(x), result.y.push_back(y), result.z.push_back(z);
}

void close(CellOrder& result) {
  result.begin.push_back(static_cast<std::uint32_t>(result.index.size()));
}

}  // namespace

void orderByCell(const LabelledCloud& cloud, double cellSize, CellOrder& result) {
  std::vector<KeyedPoint> keyed = keyedPoints(cloud, cellSize);
  std::sort(keyed.begin(), keyed.end(), [](const KeyedPoint& a, const KeyedPoint& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  clearFor(keyed.size(), result);
  for (const KeyedPoint& p : keyed) {
    addPlace(p.key, p.index, cloud.x[p.index], cloud.y[p.index], cloud.z[p.index], result);
  }
  close(result);
}

void selectMembers(const CellOrder& order, const std::vector<std::uint16_t>& membership,
                   std::uint16_t bit, CellOrder& result) {
  clearFor(order.places(), result);
  for (std::size_t cell = 0; cell < order.cells(); ++cell) {
    for (std::uint32_t p = order.begin[cell]; p < order.begin[cell + 1]; ++p) {
      if (membership[order.index[p]] & bit) {
        addPlace(order.key[cell], order.index[p], order.x[p], order.y[p], order.z[p], result);
      }
    }
  }
  close(result);
}

std::size_t lowerBoundFrom(const std::vector<CellKey>& keys, std::size_t start, CellKey wanted) {
  std::size_t step = 1, low = start;
  while (low + step < keys.size() && keys[low + step] < wanted) low += step, step *= 2;
  const auto begin = keys.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(std::min(low + step, keys.size()));
  return static_cast<std::size_t>(
      std::lower_bound(begin + static_cast<std::ptrdiff_t>(std::min(low, keys.size())), end,
                       wanted) -
      begin);
}

}  // namespace toss
