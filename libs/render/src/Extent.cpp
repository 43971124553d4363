// SPDX-License-Identifier: BSD-3-Clause
#include <toss/render/Extent.h>
#include <toss/render/PointSample.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace toss {
namespace {

// Quantiles of a sample of this size are within a fraction of a percent of those of the map.
constexpr std::size_t kQuantileSample = 200000;

std::vector<MapPoint> sampleOf(const std::vector<MapPoint>& points) {
  std::vector<MapPoint> sample;
  for (const std::uint32_t index : sampleIndices(points.size(), kQuantileSample)) {
    const MapPoint& point = points[index];
    if (std::isfinite(point.x + point.y + point.z + point.intensity)) sample.push_back(point);
  }
  return sample;
}

std::vector<float> valuesOf(const std::vector<MapPoint>& sample, float MapPoint::*member) {
  std::vector<float> values;
  values.reserve(sample.size());
  for (const MapPoint& point : sample) values.push_back(point.*member);
  return values;
}

/// The values below and above which `share` of all lie; the extremes of few values.
ValueRange quantiles(std::vector<float>& values, double share) {
  const auto cut = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  const auto low = values.begin() + cut, high = values.end() - 1 - cut;
  std::nth_element(values.begin(), low, values.end());
  const float lowValue = *low;
  std::nth_element(values.begin(), high, values.end());
  return {lowValue, *high};
}

ValueRange rangeOf(std::vector<float> values, float least) {
  if (values.empty()) return {};
  ValueRange range = quantiles(values, 0.02);
  if (range.high - range.low < least) range.high = range.low + least;
  return range;
}

}  // namespace

void Extent::include(const Eigen::Vector3d& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

bool Extent::contains(const Eigen::Vector3d& point) const {
  return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
}

std::array<Eigen::Vector3d, 8> Extent::corners() const {
  std::array<Eigen::Vector3d, 8> result;
  for (std::size_t i = 0; i < 8; ++i)
    result[i] = {i & 1u ? high.x() : low.x(), i & 2u ? high.y() : low.y(),
                 i & 4u ? high.z() : low.z()};
  return result;
}

Extent fullExtent(const std::vector<MapPoint>& points) {
  Extent extent;
  bool first = true;
  for (const MapPoint& point : points) {
    const Eigen::Vector3d position(point.x, point.y, point.z);
    if (!position.allFinite()) continue;
    if (first) extent = {position, position};
    first = false;
    extent.include(position);
  }
  return extent;
}

Extent robustExtent(const std::vector<MapPoint>& points) {
  const Extent full = fullExtent(points);
  const std::vector<MapPoint> sample = sampleOf(points);
  if (sample.empty()) return full;
  Extent extent;
  constexpr float MapPoint::*kMembers[] = {&MapPoint::x, &MapPoint::y, &MapPoint::z};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<float> values = valuesOf(sample, kMembers[axis]);
    const ValueRange range = quantiles(values, 0.002);
    const double low = range.low, high = range.high;
    const double margin = 0.02 * (high - low);
    extent.low[axis] = std::max(full.low[axis], low - margin);
    extent.high[axis] = std::min(full.high[axis], high + margin);
  }
  return extent;
}

std::vector<Eigen::Vector3d> outlineOf(const std::vector<MapPoint>& points, const Extent& extent) {
  constexpr std::size_t kCells = 64;
  std::vector<std::optional<Extent>> cells(kCells * kCells);
  const Eigen::Vector3d size = extent.size().cwiseMax(1e-6);
  for (const MapPoint& point : points) {
    const Eigen::Vector3d position(point.x, point.y, point.z);
    if (!extent.contains(position)) continue;
    const Eigen::Vector3d share = (position - extent.low).cwiseQuotient(size);
    const auto cellOf = [](double value) {
      return std::min(kCells - 1, static_cast<std::size_t>(value * kCells));
    };
    auto& cell = cells[cellOf(share.x()) * kCells + cellOf(share.y())];
    if (!cell) cell = Extent{position, position};
    cell->include(position);
  }
  std::vector<Eigen::Vector3d> outline;
  for (const auto& cell : cells)
    if (cell)
      for (const Eigen::Vector3d& corner : cell->corners()) outline.push_back(corner);
  return outline;
}

float ValueRange::position(float value) const {
  return std::clamp((value - low) / (high - low), 0.0f, 1.0f);
}

ValueRange heightRange(const std::vector<MapPoint>& points) {
  return rangeOf(valuesOf(sampleOf(points), &MapPoint::z), 0.5f);
}

ValueRange intensityRange(const std::vector<MapPoint>& points) {
  return rangeOf(valuesOf(sampleOf(points), &MapPoint::intensity), 1e-3f);
}

}  // namespace toss
