// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/OptimalAssignment.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>

namespace toss {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// Number of admissible pairs and their cost; more pairs are better, then less cost.
using Score = std::pair<int, double>;

bool isBetter(const Score& a, const Score& b) {
  return a.first != b.first ? a.first > b.first : a.second < b.second;
}

Score scoreOf(const CostMatrix& matrix, const std::vector<std::int32_t>& columnOfRow) {
  Score score{0, 0.0};
  for (int row = 0; row < matrix.rows; ++row) {
    const std::int32_t column = columnOfRow[static_cast<std::size_t>(row)];
    if (column >= 0 && matrix.at(row, column) < kForbidden) {
      score.first += 1, score.second += matrix.at(row, column);
    }
  }
  return score;
}

/// Tries every order of the columns, padded so that rows may stay alone.
Score bruteForce(const CostMatrix& matrix) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(matrix.columns + matrix.rows));
  std::iota(order.begin(), order.end(), 0);
  Score best{0, 0.0};
  do {
    std::vector<std::int32_t> chosen(order.begin(), order.begin() + matrix.rows);
    for (std::int32_t& column : chosen) column = column < matrix.columns ? column : -1;
    const Score score = scoreOf(matrix, chosen);
    if (isBetter(score, best)) best = score;
    // The order of the columns behind the last row does not matter.
    std::reverse(order.begin() + matrix.rows, order.end());
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

CostMatrix randomMatrix(std::mt19937& random, int rows, int columns, double forbidden, bool ties) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  CostMatrix matrix(rows, columns, 0.0);
  for (double& cost : matrix.costs) {
    cost = ties ? std::floor(4.0 * unit(random)) : 4.0 * unit(random);
    if (unit(random) < forbidden) cost = kForbidden;
  }
  return matrix;
}

void expectEachColumnOnce(const std::vector<std::int32_t>& columnOfRow) {
  std::set<std::int32_t> taken;
  for (const std::int32_t column : columnOfRow) {
    if (column >= 0) {
      EXPECT_TRUE(taken.insert(column).second);
    }
  }
}

TEST(SolveGatedAssignment, EqualsTheBestOfAllPermutations) {
  std::mt19937 random(17);
  std::uniform_int_distribution<int> size(1, 4);
  for (int trial = 0; trial < 600; ++trial) {
    const CostMatrix matrix =
        randomMatrix(random, size(random), size(random), 0.2 * (trial % 5), trial % 2 == 0);
    const auto solution = solveGatedAssignment(matrix);
    expectEachColumnOnce(solution);
    const Score best = bruteForce(matrix), found = scoreOf(matrix, solution);
    EXPECT_EQ(found.first, best.first) << "trial " << trial;
    EXPECT_NEAR(found.second, best.second, 1e-9) << "trial " << trial;
  }
}

TEST(SolveAssignment, FillsTheSmallerSideAtLeastCost) {
  std::mt19937 random(19);
  std::uniform_int_distribution<int> size(1, 4);
  for (int trial = 0; trial < 300; ++trial) {
    const CostMatrix matrix = randomMatrix(random, size(random), size(random), 0.0, false);
    const auto solution = solveAssignment(matrix);
    expectEachColumnOnce(solution);
    const Score best = bruteForce(matrix), found = scoreOf(matrix, solution);
    EXPECT_EQ(found.first, std::min(matrix.rows, matrix.columns));
    EXPECT_NEAR(found.second, best.second, 1e-9) << "trial " << trial;
  }
}

/// No better exchange of two rows: necessary for an optimum, and checked at sizes beyond brute
/// force.
TEST(SolveAssignment, LargeSolutionsCannotBeImprovedByExchanges) {
  std::mt19937 random(23);
  const CostMatrix matrix = randomMatrix(random, 60, 80, 0.0, false);
  const auto solution = solveAssignment(matrix);
  expectEachColumnOnce(solution);
  for (int a = 0; a < matrix.rows; ++a) {
    const std::int32_t columnOfA = solution[static_cast<std::size_t>(a)];
    for (int b = 0; b < a; ++b) {
      const std::int32_t columnOfB = solution[static_cast<std::size_t>(b)];
      EXPECT_LE(matrix.at(a, columnOfA) + matrix.at(b, columnOfB),
                matrix.at(a, columnOfB) + matrix.at(b, columnOfA) + 1e-9);
    }
  }
}

TEST(SolveGatedAssignment, TakesEmptyAndWhollyForbiddenMatrices) {
  EXPECT_TRUE(solveGatedAssignment(CostMatrix(0, 3, 0.0)).empty());
  EXPECT_EQ(solveGatedAssignment(CostMatrix(2, 0, 0.0)), (std::vector<std::int32_t>{-1, -1}));
  EXPECT_EQ(solveGatedAssignment(CostMatrix(2, 2, kForbidden)),
            (std::vector<std::int32_t>{-1, -1}));
}

}  // namespace
}  // namespace toss
