// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <algorithm>

namespace toss {

/// Looks at what the beams right above a return meet: something upright is hit by several beams on
/// a steep line, while beams meet ground ever farther away.
class UprightNeighbours {
 public:
  /// `slope`: rise over run from which a line is steep; 0 or less finds nothing steep. All
  /// references must outlive this.
  UprightNeighbours(const LevelPoints& points, const RangeImage& image, float slope)
      : points_(points), image_(image), squaredSlope_(slope > 0.0f ? slope * slope : -1.0f) {}

  /// Whether a return that `accept(index)` holds for lies steeply above return `point`.
  template <typename Accept>
  bool anyAbove(std::size_t point, const Accept& accept) const {
    if (squaredSlope_ < 0.0f) return false;
    const int row = image_.row[point], column = image_.column[point];
    for (int above = row - 1; above >= std::max(0, row - kRows); --above) {
      for (int side = -kColumns; side <= kColumns; ++side) {
        const std::int32_t other = image_.at(above, wrapped(column + side));
        if (other == RangeImage::kNone) continue;
        const auto upper = static_cast<std::size_t>(other);
        if (isSteep(upper, point) && accept(upper)) return true;
      }
    }
    return false;
  }
  bool anyAbove(std::size_t point) const {
    return anyAbove(point, [](std::size_t) { return true; });
  }

 private:
  /// Beams above, and columns to either side.
  static constexpr int kRows = 2, kColumns = 1;

  /// A column up to kColumns beyond either end of a row, around the seam.
  int wrapped(int column) const {
    if (column < 0) return std::max(0, column + image_.columns);
    return column < image_.columns ? column : std::max(0, column - image_.columns);
  }

  bool isSteep(std::size_t upper, std::size_t lower) const {
    const float dx = points_.x[upper] - points_.x[lower], dy = points_.y[upper] - points_.y[lower];
    const float rise = points_.z[upper] - points_.z[lower];
    return rise > 0.0f && rise * rise > squaredSlope_ * (dx * dx + dy * dy);
  }

  const LevelPoints& points_;
  const RangeImage& image_;
  float squaredSlope_;
};

}  // namespace toss
