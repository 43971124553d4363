// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/CandidateSearch.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Keeps cell numbers in 32 bits. Points beyond share the outermost cells, which is still exact.
constexpr double kLastCell = 1e9;

}  // namespace

CandidateSearch::CandidateSearch(const std::vector<AssociationTarget>& targets)
    : targets_(targets) {
  double reach = 0.0;
  for (const AssociationTarget& target : targets) reach = std::max(reach, target.reach);
  if (reach > 0.0) cellSize_ = reach;
  cells_.reserve(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Eigen::Vector3d& center = targets[i].predicted.center;
    cells_.emplace_back(key(cell(center.x()), cell(center.y())), static_cast<std::int32_t>(i));
  }
  std::sort(cells_.begin(), cells_.end());
}

std::int64_t CandidateSearch::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::clamp(std::floor(coordinate / cellSize_), -kLastCell, kLastCell));
}

CandidateSearch::CellKey CandidateSearch::key(std::int64_t x, std::int64_t y) const {
  constexpr std::int64_t kOffset = std::int64_t{1} << 31;
  return (static_cast<CellKey>(x + kOffset) << 32) | static_cast<CellKey>(y + kOffset);
}

void CandidateSearch::nearest(const Eigen::Vector3d& point, int count,
                              std::vector<Candidate>& result) const {
  result.clear();
  const std::int64_t x = cell(point.x()), y = cell(point.y());
  for (std::int64_t column = x - 1; column <= x + 1; ++column) {
    const CellKey last = key(column, y + 1);
    auto entry = std::lower_bound(cells_.begin(), cells_.end(),
                                  std::make_pair(key(column, y - 1), std::int32_t{-1}));
    for (; entry != cells_.end() && entry->first <= last; ++entry) {
      const AssociationTarget& target = targets_[static_cast<std::size_t>(entry->second)];
      const double squared = (target.predicted.center - point).squaredNorm();
      if (squared <= target.reach * target.reach) {
        result.push_back({std::sqrt(squared), entry->second});
      }
    }
  }
  const auto kept = std::min(result.size(), static_cast<std::size_t>(count));
  std::partial_sort(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(kept),
                    result.end());
  result.resize(kept);
}

}  // namespace toss
