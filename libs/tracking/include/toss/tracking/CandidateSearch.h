// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <cstdint>
#include <tuple>
#include <vector>

namespace toss {

/// Finds the traces whose reach covers a point: a horizontal grid over the predicted centres, its
/// cells as wide as the largest reach, so that 3 x 3 cells hold all of them (spec section 5.6). The
/// grid is rolled up into a torus with a few cells per trace: time and memory are linear in
/// the traces wherever they are, and cells that come to lie on each other cost a distance each.
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

  explicit CandidateSearch(const std::vector<AssociationTarget>& targets);

  /// The `count` nearest targets that have `point` [m, map frame] in reach, nearest first.
  void nearest(const Eigen::Vector3d& point, int count, std::vector<Candidate>& result) const;

 private:
  struct Entry {
    Eigen::Vector3d center;
    double squaredReach;
    std::int32_t target;
  };
  std::int64_t cell(double coordinate) const;
  std::size_t place(std::int64_t x, std::int64_t y) const;
  void visit(std::size_t firstPlace, std::size_t lastPlace, const Eigen::Vector3d& point,
             std::vector<Candidate>& result) const;

  double cellsPerMetre_ = 1.0;
  /// Edge of the torus in cells, a power of two.
  std::size_t edge_ = 4;
  /// The targets place by place of the torus, those of place p from begin_[p] to begin_[p + 1].
  std::vector<Entry> entries_;
  std::vector<std::int32_t> begin_;
};

}  // namespace toss
