// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MapTruth.h>
#include <toss/evaluation/NearestNeighbors.h>
#include <toss/rawlog/LabelFile.h>

#include <algorithm>
#include <limits>

namespace toss {

MapTruth::MapTruth(LabelledCloud map, double cellSize, bool ignoreUnlabelled)
    : ignoreUnlabelled_(ignoreUnlabelled), map_(std::move(map)) {
  orderByCell(map_, cellSize, order_);
  nearest_.assign(order_.places(), Nearest{cellSize * cellSize});
  if (ignoreUnlabelled_) nearestAnnotated_ = nearest_;
}

void MapTruth::offer(double squared, std::uint32_t returnIndex, std::uint32_t label,
                     Nearest& best) const {
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
      const bool annotated = ignoreUnlabelled_ && label::semantic(label[index]) != 0;
      for (std::uint32_t m = first; m < end; ++m) {
        const double squared =
            squaredDistance(scan.x[p], scan.y[p], scan.z[p], order_.x[m], order_.y[m], order_.z[m]);
        squaredDistanceToMap[p] = std::min(squaredDistanceToMap[p], squared);
        offer(squared, index, label[index], nearest_[m]);
        if (annotated) offer(squared, index, label[index], nearestAnnotated_[m]);
      }
    }
  });
  ++scans_;
}

std::uint32_t MapTruth::labelOf(std::size_t place) const {
  const std::uint32_t nearest = nearest_[place].label;
  if (!ignoreUnlabelled_ || label::semantic(nearest) != 0) return nearest;
  const Nearest& annotated = nearestAnnotated_[place];
  return annotated.scan >= 0 && !label::isMoving(annotated.label) ? annotated.label : nearest;
}

LabelledCloud MapTruth::labelled(std::uint32_t unseenLabel) const {
  LabelledCloud result = map_;
  result.label.assign(map_.size(), unseenLabel);
  for (std::size_t p = 0; p < nearest_.size(); ++p) {
    if (nearest_[p].scan >= 0) result.label[order_.index[p]] = labelOf(p);
  }
  return result;
}

std::uint64_t MapTruth::unseenPoints() const {
  return static_cast<std::uint64_t>(
      std::count_if(nearest_.begin(), nearest_.end(), [](const Nearest& n) { return n.scan < 0; }));
}

}  // namespace toss
