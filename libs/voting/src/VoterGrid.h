// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <algorithm>

#include "VoteRules.h"

namespace toss {

/// The boxes of one square of the ground plane.
struct VoterCell {
  /// Place in the grid, in units of the cell size.
  std::int64_t column = 0, row = 0;
  /// Boxes by ascending id, and with it by time; those before `first` are forgotten.
  std::vector<Voter> voters;
  std::size_t first = 0;
  /// How many of them are of traces that can vote for dynamic: mostly none.
  int dynamicVoters = 0;
  /// Boxes that a vote for static may turn; may hold some that no longer wait, in any order.
  std::vector<Voter> pending;

  const Voter* begin() const { return voters.data() + first; }
  const Voter* end() const { return voters.data() + voters.size(); }
};

/// Spatial index of boxes over x and y (spec section 7.4). Boxes come and go in order of time.
class VoterGrid {
 public:
  using CellIndex = std::uint32_t;

  /// `cellSize` [m]: also the largest radius that visit() may be asked for.
  explicit VoterGrid(double cellSize) : cellsPerMetre_(1.0 / cellSize) {}

  /// Adds a box that is later than all others, or of the latest scan; returns its cell.
  CellIndex insert(const Voter& voter);
  /// Takes the earliest box of the cell out; a cell left empty is given up.
  void removeEarliest(CellIndex index);

  VoterCell& cell(CellIndex index) { return cells_[index]; }
  /// The box of that id in that cell; it must be there.
  const Voter& find(CellIndex index, BoxId box) const;

  /// Calls `visit(VoterCell&)` for every cell that is within `radius` of `center` along x and y.
  template <typename Visit>
  void visit(const Eigen::Vector3d& center, double radius, Visit&& visit) {
    const std::int64_t lastColumn = coordinate(center.x() + radius);
    const std::int64_t lastRow = coordinate(center.y() + radius);
    for (std::int64_t c = coordinate(center.x() - radius); c <= lastColumn; ++c) {
      for (std::int64_t r = coordinate(center.y() - radius); r <= lastRow; ++r) {
        const auto found = indexOf_.find(key(c, r));
        if (found != indexOf_.end()) visit(cells_[found->second]);
      }
    }
  }

  /// Calls `visit(VoterCell&)` for the given cell and for all that touch it.
  template <typename Visit>
  void visitAround(CellIndex index, Visit&& visit) {
    const std::int64_t column = cells_[index].column, row = cells_[index].row;
    for (std::int64_t c = column - 1; c <= column + 1; ++c) {
      for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        const auto found = indexOf_.find(key(c, r));
        if (found != indexOf_.end()) visit(cells_[found->second]);
      }
    }
  }

 private:
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return (static_cast<std::uint64_t>(column) << 32) ^
           (static_cast<std::uint64_t>(row) & 0xffffffff);
  }
  /// Number of a cell along one axis. Rounds down by hand: calls of std::floor take long.
  std::int64_t coordinate(double metres) const {
    constexpr double kLargest = 1e9;
    const double cells = std::clamp(metres * cellsPerMetre_, -kLargest, kLargest);
    const auto towardsZero = static_cast<std::int64_t>(cells);
    return towardsZero - (cells < static_cast<double>(towardsZero) ? 1 : 0);
  }

  /// The standard hash of a whole number is itself: all cells of a row would share their slot.
  struct Hash {
    std::size_t operator()(std::uint64_t key) const {
      key *= 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(key ^ key >> 32);
    }
  };

  double cellsPerMetre_;
  tsl::robin_map<std::uint64_t, CellIndex, Hash> indexOf_;
  std::vector<VoterCell> cells_;
  std::vector<CellIndex> free_;
};

}  // namespace toss
