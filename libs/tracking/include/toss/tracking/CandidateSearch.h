// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace toss {

/// Finds the traces whose reach covers a point: a horizontal grid over the predicted centres, its
/// cells as wide as the largest reach, so that 3 x 3 cells hold all of them (spec section 5.6).
class CandidateSearch {
 public:
  struct Candidate {
    /// Distance of the predicted centre [m] and index of the target.
    double distance;
    std::int32_t target;

    bool operator<(const Candidate& other) const {
      return std::tie(distance, target) < std::tie(other.distance, other.target);
    }
  };

  /// Keeps a reference to `targets`.
  explicit CandidateSearch(const std::vector<AssociationTarget>& targets);

  /// The `count` nearest targets that have `point` [m, map frame] in reach, nearest first.
  void nearest(const Eigen::Vector3d& point, int count, std::vector<Candidate>& result) const;

 private:
  /// Order-preserving key of a cell: cells of one x that follow each other in y have keys in a row.
  using CellKey = std::uint64_t;
  CellKey key(std::int64_t x, std::int64_t y) const;
  std::int64_t cell(double coordinate) const;

  const std::vector<AssociationTarget>& targets_;
  double cellSize_ = 1.0;
  /// Cell of each target with the target's index, ascending.
  std::vector<std::pair<CellKey, std::int32_t>> cells_;
};

}  // namespace toss
