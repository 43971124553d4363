// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/CandidateSearch.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Keeps cell numbers whole. Points beyond share the outermost cells, which is still exact.
constexpr double kLastCell = 1e9;
/// Cells are wider than the reach by this factor, so that rounding skips no cell.
constexpr double kWider = 1.001;

}  // namespace

CandidateSearch::CandidateSearch(const std::vector<AssociationTarget>& targets) {
  double reach = 0.0;
  for (const AssociationTarget& target : targets) reach = std::max(reach, target.reach);
  if (reach > 0.0) cellsPerMetre_ = 1.0 / (kWider * reach);
  while (edge_ * edge_ < 2 * targets.size()) edge_ *= 2;
  // Counting sort by place.
  begin_.assign(edge_ * edge_ + 2, 0);
  std::vector<std::size_t> placeOf;
  placeOf.reserve(targets.size());
  for (const AssociationTarget& target : targets) {
    const Eigen::Vector3d& center = target.predicted.center;
    placeOf.push_back(place(cell(center.x()), cell(center.y())));
    ++begin_[placeOf.back() + 2];
  }
  for (std::size_t p = 2; p < begin_.size(); ++p) begin_[p] += begin_[p - 1];
  entries_.resize(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
    entries_[static_cast<std::size_t>(begin_[placeOf[i] + 1]++)] = {
        targets[i].predicted.center, targets[i].reach * targets[i].reach,
        static_cast<std::int32_t>(i)};
}

std::int64_t CandidateSearch::cell(double coordinate) const {
  return static_cast<std::int64_t>(
      std::floor(std::clamp(coordinate * cellsPerMetre_, -kLastCell, kLastCell)));
}

std::size_t CandidateSearch::place(std::int64_t x, std::int64_t y) const {
  const std::size_t mask = edge_ - 1;
  return (static_cast<std::size_t>(x) & mask) * edge_ + (static_cast<std::size_t>(y) & mask);
}

void CandidateSearch::visit(std::size_t firstPlace, std::size_t lastPlace,
                            const Eigen::Vector3d& point, std::vector<Candidate>& result) const {
  for (std::int32_t e = begin_[firstPlace]; e < begin_[lastPlace + 1]; ++e) {
    const Entry& entry = entries_[static_cast<std::size_t>(e)];
    const double squared = (entry.center - point).squaredNorm();
    if (squared <= entry.squaredReach) result.push_back({std::sqrt(squared), entry.target});
  }
}

void CandidateSearch::nearest(const Eigen::Vector3d& point, int count,
                              std::vector<Candidate>& result) const {
  result.clear();
  const std::int64_t x = cell(point.x()), y = cell(point.y());
  for (std::int64_t column = x - 1; column <= x + 1; ++column) {
    const std::size_t first = place(column, y - 1), last = place(column, y + 1);
    if (first < last) {
      visit(first, last, point, result);
    } else {
      for (std::int64_t row = y - 1; row <= y + 1; ++row)
        visit(place(column, row), place(column, row), point, result);
    }
  }
  const auto kept = std::min(result.size(), static_cast<std::size_t>(count));
  std::partial_sort(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(kept),
                    result.end());
  result.resize(kept);
}

}  // namespace toss
