// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MapTruth.h>
#include <toss/evaluation/NearestNeighbors.h>

#include <algorithm>
#include <limits>

namespace toss {

MapTruth::MapTruth(LabelledCloud map, double cellSize) : cellSize_(cellSize), map_(std::move(map)) {
  orderByCell(map_, cellSize, order_);
  nearest_.assign(order_.places(), Nearest{cellSize_ * cellSize_});
}

void MapTruth::offer(std::uint32_t place, double squared, std::uint32_t returnIndex,
                     std::uint32_t label) {
  Nearest& best = nearest_[place];
  const bool tie = squared == best.squared && best.scan == scans_ && returnIndex < best.index;
  if (squared < best.squared || tie) {
    best.squared = squared, best.scan = scans_, best.index = returnIndex, best.label = label;
  }
}

void MapTruth::addScan(const CellOrder& scan, const std::vector<std::uint32_t>& label,
                       std::vector<double>& squaredDistanceToMap) {
  squaredDistanceToMap.assign(scan.places(), std::numeric_limits<double>::infinity());
  joinCells(scan, order_, [&](std::size_t cell, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t p = scan.begin[cell]; p < scan.begin[cell + 1]; ++p) {
      const std::uint32_t index = scan.index[p];
      for (std::uint32_t m = first; m < end; ++m) {
        const double squared =
            squaredDistance(scan.x[p], scan.y[p], scan.z[p], order_.x[m], order_.y[m], order_.z[m]);
        squaredDistanceToMap[p] = std::min(squaredDistanceToMap[p], squared);
        offer(m, squared, index, label[index]);
      }
    }
  });
  ++scans_;
}

LabelledCloud MapTruth::labelled(std::uint32_t unknownLabel) const {
  LabelledCloud result = map_;
  result.label.assign(map_.size(), unknownLabel);
  for (std::size_t p = 0; p < nearest_.size(); ++p) {
    if (nearest_[p].scan >= 0) result.label[order_.index[p]] = nearest_[p].label;
  }
  return result;
}

std::uint64_t MapTruth::unknownPoints() const {
  return static_cast<std::uint64_t>(
      std::count_if(nearest_.begin(), nearest_.end(), [](const Nearest& n) { return n.scan < 0; }));
}

}  // namespace toss
