// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectOptions.h>
#include <toss/segmentation/RangeImage.h>

#include <algorithm>
#include <cstdint>

namespace toss {

/// When two returns of a range image belong to one object. Returns a and b are linked if
///   - their rows differ by at most rowWindow,
///   - their columns differ by at most the window of each (columns - 1 and 0 are neighbours),
///   - their horizontal distance is below the link distance of each: `horizontal` within a row,
///     `vertical` between rows,
///   - they differ in height by at most maxHeightGap where rows lie between theirs.
/// Returns of neighbouring rows and at most one column apart, both at least surfaceDepth below the
/// sensor, are linked as well if their horizontal distance is below surfaceDistance.
/// The link distances follow spec section 3.3; as they grow with range, the smaller of the two is
/// that of the nearer return.
class LinkRules {
 public:
  /// Steps are taken from the image: 2 pi / columns, and the mean distance of its rows.
  LinkRules(const ObjectOptions& options, const RangeImage& image);

  /// Link distance [m]: range times angle, within bounds, and then times a factor. It grows with
  /// range.
  struct Distance {
    float angle, least, most, factor;
    float at(float range) const { return factor * std::min(std::max(range * angle, least), most); }
    /// The same distance [m] at any range.
    static Distance constant(float distance) { return {0.0f, distance, distance, 1.0f}; }
  };

  /// What a return at one range reaches.
  struct Reach {
    /// Link distances [m] within a row and between rows.
    float horizontal, vertical;
    /// Columns within which a linked return must lie: all those that the link distances can span.
    std::int32_t window;
  };
  /// `range`: horizontal distance from the sensor [m].
  Reach reach(float range) const {
    const float within = horizontal.at(range), between = vertical.at(range);
    return {within, between, columnsSpanned(std::max(within, between), range)};
  }
  /// The same rules with all link distances times `factor`.
  LinkRules shortened(float factor) const;

  /// Columns and rows that a distance [m] spans at most at `range` [m]; up to half the columns.
  std::int32_t columnsSpanned(float distance, float range) const {
    return steps(distance, range, columnStep, columns / 2);
  }
  std::int32_t rowsSpanned(float distance, float range) const {
    return steps(distance, range, rowStep, rows);
  }

  /// Fewest returns of an instance, and of a part split off, whose nearest return is at `range`
  /// [m].
  int minPoints(float range) const;
  int minPointsOfPart(float range) const;

  /// Angle [rad] between neighbouring columns, and between neighbouring rows on average.
  float columnStep, rowStep;
  int rows, columns, rowWindow;
  /// [m]
  float maxHeightGap, surfaceDistance, surfaceDepth;
  /// Link distances within a row, and between rows.
  Distance horizontal, vertical;

 private:
  Distance distance(double base, float angle) const;
  int returnsOn(double size, float range) const;

  /// A distance d spans at most asin(d / range), which s + s^3 / 4 exceeds for s = d / range up to
  /// 50 degrees; one more step because returns lie anywhere in their pixels, and one to round up.
  /// Where beams rise or fall steeply columns are narrower, and a link at the very limit may be
  /// missed.
  static std::int32_t steps(float distance, float range, float step, int most) {
    const float sine = distance / std::max(range, 0.01f);
    const float spanned = (sine + 0.25f * sine * sine * sine) / step + 2.0f;
    return static_cast<std::int32_t>(std::min(spanned, static_cast<float>(most)));
  }

  ObjectOptions options_;
};

}  // namespace toss
