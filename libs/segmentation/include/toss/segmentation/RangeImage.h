// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// A scan laid out by beam (row) and azimuth (column): spherical projection, paper Eq. 1 as
/// corrected in spec section 1.2. Row 0 is the topmost beam. Column 0 lies at the rear (azimuth
/// +pi) and columns grow clockwise seen from above; columns - 1 and 0 are neighbours. The nearest
/// return of a pixel represents it, the others hang on it in a chain, so that none is lost.
struct RangeImage {
  /// Marks "no point" in `representative` and `next`, and "no row" in `row`.
  static constexpr std::int32_t kNone = -1;
  static constexpr std::uint16_t kNoRow = 0xFFFF;

  int rows = 0, columns = 0;
  /// Point index of the nearest return in each pixel or kNone, row-major, shape [rows * columns].
  std::vector<std::int32_t> representative;
  /// Another return of the same pixel or kNone, shape [n]. Only the head of a chain is sorted: it
  /// is the nearest, the others follow in a fixed order of their own.
  std::vector<std::int32_t> next;
  /// Pixel of each point, shape [n]; row is kNoRow for points that are INVALID or OUT_OF_RANGE.
  std::vector<std::uint16_t> row, column;
  /// 3D distance of each point from the sensor [m], shape [n]; 0 for INVALID points.
  std::vector<float> range;
  /// Elevation of each row [rad], topmost first, shape [rows].
  std::vector<float> elevations;

  std::size_t pixel(int r, int c) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(c);
  }
  std::int32_t at(int r, int c) const { return representative[pixel(r, c)]; }
  /// Mean angle between neighbouring rows [rad], 0 where there are fewer than two.
  float meanRowSpacing() const {
    if (elevations.size() < 2) return 0.0f;
    return (elevations.front() - elevations.back()) / static_cast<float>(elevations.size() - 1);
  }
};

}  // namespace toss
