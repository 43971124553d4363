// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/OptimalAssignment.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int32_t kNone = -1;

/// Successive shortest augmenting paths, for matrices with no more rows than columns.
class ShortestPathSolver {
 public:
  explicit ShortestPathSolver(const CostMatrix& matrix)
      : matrix_(matrix),
        rowPotential_(static_cast<std::size_t>(matrix.rows), 0.0),
        columnPotential_(static_cast<std::size_t>(matrix.columns), 0.0),
        rowOfColumn_(static_cast<std::size_t>(matrix.columns), kNone) {}

  std::vector<std::int32_t> solve() {
    for (std::int32_t row = 0; row < matrix_.rows; ++row) assign(row);
    std::vector<std::int32_t> columnOfRow(static_cast<std::size_t>(matrix_.rows), kNone);
    for (std::size_t column = 0; column < rowOfColumn_.size(); ++column) {
      const std::int32_t row = rowOfColumn_[column];
      if (row != kNone) {
        columnOfRow[static_cast<std::size_t>(row)] = static_cast<std::int32_t>(column);
      }
    }
    return columnOfRow;
  }

 private:
  /// Grows a tree of shortest paths from `root` until it meets a free column, then swaps the pairs
  /// along the path.
  void assign(std::int32_t root) {
    distance_.assign(rowOfColumn_.size(), kInfinity);
    previous_.assign(rowOfColumn_.size(), kNone);
    finished_.assign(rowOfColumn_.size(), false);
    std::int32_t row = root, last = kNone;
    double reached = 0.0;
    while (row != kNone) {
      relax(row, last, reached);
      last = nearestColumn();
      finished_[static_cast<std::size_t>(last)] = true;
      reached = distance_[static_cast<std::size_t>(last)];
      row = rowOfColumn_[static_cast<std::size_t>(last)];
    }
    raisePotentials(root, reached);
    augment(root, last);
  }

  void relax(std::int32_t row, std::int32_t from, double reached) {
    const double* costs = &matrix_.costs[static_cast<std::size_t>(row) * rowOfColumn_.size()];
    const double base = reached - rowPotential_[static_cast<std::size_t>(row)];
    for (std::size_t column = 0; column < rowOfColumn_.size(); ++column) {
      const double through = base + costs[column] - columnPotential_[column];
      if (!finished_[column] && through < distance_[column]) {
        distance_[column] = through;
        previous_[column] = from;
      }
    }
  }

  /// Of equally near columns a free one, which ends the search; else the first.
  std::int32_t nearestColumn() const {
    std::size_t best = rowOfColumn_.size();
    for (std::size_t column = 0; column < rowOfColumn_.size(); ++column) {
      if (finished_[column]) continue;
      const bool nearer = best == rowOfColumn_.size() || distance_[column] < distance_[best];
      const bool freed = !nearer && distance_[column] == distance_[best] &&
                         rowOfColumn_[best] != kNone && rowOfColumn_[column] == kNone;
      if (nearer || freed) best = column;
    }
    return static_cast<std::int32_t>(best);
  }

  void raisePotentials(std::int32_t root, double reached) {
    rowPotential_[static_cast<std::size_t>(root)] += reached;
    for (std::size_t column = 0; column < rowOfColumn_.size(); ++column) {
      if (!finished_[column] || rowOfColumn_[column] == kNone) continue;
      const double slack = reached - distance_[column];
      columnPotential_[column] -= slack;
      rowPotential_[static_cast<std::size_t>(rowOfColumn_[column])] += slack;
    }
  }

  void augment(std::int32_t root, std::int32_t column) {
    while (column != kNone) {
      const auto at = static_cast<std::size_t>(column);
      const std::int32_t before = previous_[at];
      rowOfColumn_[at] = before == kNone ? root : rowOfColumn_[static_cast<std::size_t>(before)];
      column = before;
    }
  }

  const CostMatrix& matrix_;
  std::vector<double> rowPotential_, columnPotential_, distance_;
  std::vector<std::int32_t> rowOfColumn_, previous_;
  std::vector<bool> finished_;
};

CostMatrix transposed(const CostMatrix& matrix) {
  CostMatrix result(matrix.columns, matrix.rows, 0.0);
  for (int row = 0; row < matrix.rows; ++row) {
    for (int column = 0; column < matrix.columns; ++column) {
      result.at(column, row) = matrix.at(row, column);
    }
  }
  return result;
}

std::vector<std::int32_t> inverted(const std::vector<std::int32_t>& assignment, int size) {
  std::vector<std::int32_t> result(static_cast<std::size_t>(size), kNone);
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    if (assignment[i] != kNone) {
      result[static_cast<std::size_t>(assignment[i])] = static_cast<std::int32_t>(i);
    }
  }
  return result;
}

}  // namespace

std::vector<std::int32_t> solveAssignment(const CostMatrix& matrix) {
  if (matrix.rows <= matrix.columns) return ShortestPathSolver(matrix).solve();
  return inverted(ShortestPathSolver(transposed(matrix)).solve(), matrix.rows);
}

std::vector<std::int32_t> solveGatedAssignment(const CostMatrix& matrix) {
  double largest = 0.0;
  for (const double cost : matrix.costs) {
    if (cost < kInfinity) largest = std::max(largest, std::abs(cost));
  }
  // One pair more outweighs any exchange of costs among the others. Since all forbidden pairs cost
  // the same, taking one is the same as staying alone.
  const double alone = 1.0 + 2.0 * largest * std::min(matrix.rows, matrix.columns);
  CostMatrix finite = matrix;
  for (double& cost : finite.costs) cost = std::min(cost, alone);
  std::vector<std::int32_t> columnOfRow = solveAssignment(finite);
  for (int row = 0; row < matrix.rows; ++row) {
    std::int32_t& column = columnOfRow[static_cast<std::size_t>(row)];
    if (column != kNone && matrix.at(row, column) == kInfinity) column = kNone;
  }
  return columnOfRow;
}

}  // namespace toss
