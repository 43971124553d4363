// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/ObjectOptions.h>
#include <toss/segmentation/RangeImage.h>

namespace toss {

/// When two returns of a range image belong to one object. Returns a and b are linked if
///   - their rows differ by at most rowWindow,
///   - their columns differ by at most the window of each (columns - 1 and 0 are neighbours),
///   - their horizontal distance is below the link distance of each: `horizontal` within a row,
///     `vertical` between rows,
///   - they differ in height by at most maxHeightGap where rows lie between theirs.
/// The link distances follow spec section 3.3; as they grow with range, the smaller of the two is
/// that of the nearer return.
class LinkRules {
 public:
  /// Steps are taken from the image: 2 pi / columns, and the mean distance of its rows.
  LinkRules(const ObjectOptions& options, const RangeImage& image);

  /// What a return at one range reaches.
  struct Reach {
    /// Link distances [m] within a row and between rows.
    float horizontal, vertical;
    /// Columns within which a linked return must lie: all those that the link distances can span.
    int window;
  };
  /// `range`: horizontal distance from the sensor [m].
  Reach reach(float range) const;
  /// Fewest returns of an instance whose nearest return is at `range` [m].
  int minPoints(float range) const;

  /// Angle [rad] between neighbouring columns, and between neighbouring rows on average.
  float columnStep, rowStep;
  int columns, rowWindow;
  /// [m]
  float maxHeightGap;

 private:
  float linkDistance(float range, double base, double steps, float step) const;
  ObjectOptions options_;
};

}  // namespace toss
