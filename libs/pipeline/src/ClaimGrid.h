// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace toss {

/// Squares of the ground plane around the sensor, level frame, by which returns and boxes find each
/// other: small ones, and cells of 2 x 2 of them. All that lies beyond belongs to the outermost.
class ClaimGrid {
 public:
  /// Squares along each axis, and their side [m].
  static constexpr std::int32_t kSquares = 512, kCells = kSquares / 2;
  static constexpr float kSide = 0.5f;
  /// Keeps returns on the edge of an area from being missed through rounding [m].
  static constexpr float kRounding = 1e-3f;

  /// Number of a square along one axis; 0 for what is not a number.
  static std::int32_t along(float coordinate) {
    constexpr float kHalf = 0.5f * kSide * static_cast<float>(kSquares);
    constexpr auto kLast = static_cast<float>(kSquares - 1);
    const float square = std::max(0.0f, (coordinate + kHalf) * (1.0f / kSide));
    return static_cast<std::int32_t>(std::min(square, kLast));
  }
  static std::int32_t squareOf(float x, float y) { return along(x) * kSquares + along(y); }
  /// The squares of `n` returns: the compiler vectorises this only as a function of arrays that are
  /// known not to overlap.
  static void findSquares(const float* __restrict x, const float* __restrict y, std::size_t n,
                          std::int32_t* __restrict square);
  static std::size_t cellOfSquare(std::int32_t square) {
    const auto number = static_cast<std::uint32_t>(square);
    const std::uint32_t row = number / kSquares, column = number % kSquares;
    return row / 2 * kCells + column / 2;
  }

  /// Calls `visit(square)`, and `visit(cell)`, for each one that an area meets.
  template <typename Visit>
  static void visitSquares(const Eigen::AlignedBox2f& area, Visit&& visit) {
    if (area.isEmpty()) return;
    const std::int32_t lastRow = along(area.max().x()), lastColumn = along(area.max().y());
    for (std::int32_t row = along(area.min().x()); row <= lastRow; ++row)
      for (std::int32_t column = along(area.min().y()); column <= lastColumn; ++column)
        visit(static_cast<std::size_t>(row) * kSquares + static_cast<std::size_t>(column));
  }
  template <typename Visit>
  static void visitCells(const Eigen::AlignedBox2f& area, Visit&& visit) {
    if (area.isEmpty()) return;
    const std::int32_t lastRow = along(area.max().x()) / 2, lastColumn = along(area.max().y()) / 2;
    for (std::int32_t row = along(area.min().x()) / 2; row <= lastRow; ++row)
      for (std::int32_t column = along(area.min().y()) / 2; column <= lastColumn; ++column)
        visit(static_cast<std::size_t>(row) * kCells + static_cast<std::size_t>(column));
  }
};

}  // namespace toss
