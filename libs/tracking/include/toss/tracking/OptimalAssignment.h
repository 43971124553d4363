// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace toss {

/// A matrix of costs, row-major, shape [rows * columns].
struct CostMatrix {
  int rows = 0, columns = 0;
  std::vector<double> costs;

  CostMatrix() = default;
  CostMatrix(int rowCount, int columnCount, double fill)
      : rows(rowCount),
        columns(columnCount),
        costs(static_cast<std::size_t>(rowCount) * static_cast<std::size_t>(columnCount), fill) {}

  double& at(int row, int column) { return costs[index(row, column)]; }
  double at(int row, int column) const { return costs[index(row, column)]; }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

/// Column of each row, -1 = none, so that min(rows, columns) pairs have the least total cost:
/// successive shortest paths with potentials (Hungarian method), O(min^2 * max). Costs finite.
std::vector<std::int32_t> solveAssignment(const CostMatrix& matrix);

/// The same where pairs may be forbidden, marked by a cost of infinity: most pairs, and among those
/// the least total cost. No admissible pair is given up for the sake of forbidden ones.
std::vector<std::int32_t> solveGatedAssignment(const CostMatrix& matrix);

}  // namespace toss
