// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How near two returns must be to be of one object.
enum class LinkMetric {
  Adaptive,  ///< grows with range, as the spacing of the beams does (spec section 3.3)
  Constant   ///< the same at every range, as TRAVEL does (spec section 3.1)
};

/// Options of the object segmentation, section [objects]. Sensor-independent: windows follow from
/// the distances and from the spacing of the sensor's beams.
struct ObjectOptions : Options {
  /// Adaptive or constant link distances.
  LinkMetric metric = LinkMetric::Adaptive;
  /// Greatest horizontal distance [m] of linked returns in one row and in different rows: the
  /// constant, and the base of the adaptive distance.
  double horizontalDistance = 0.4, verticalDistance = 0.5;
  /// The adaptive distance stays within these multiples of the base.
  double nearFactor = 0.4, farFactor = 1.5;
  /// The adaptive distance is range times angle, the angle counted in column and in row steps of
  /// the sensor: 3.4 columns are 0.6 degrees, 1.8 rows 0.75 degrees with HDL-64E.
  double horizontalSteps = 3.4, verticalSteps = 1.8;
  /// Rows that a link may reach up or down [rows].
  int rowWindow = 3;
  /// Greatest difference in height [m] of returns linked across at least one row in between.
  double maxHeightGap = 1.0;

  /// Returns of one pixel whose ranges differ less [m] are one surface.
  double pixelMerge = 0.3;
  /// A return left over by clustering is given to an instance that is this near [m]; 0 = never.
  double attachDistance = 0.3;

  /// Fewest returns of an instance: as many as a surface of `minSize` x `minSize` [m] catches at
  /// that range, but at least `minPointsFar` and at most `minPointsNear`.
  int minPointsNear = 10, minPointsFar = 3;
  double minSize = 0.3;
  /// Most returns of an instance; clusters above it stay without instance. 0 = no limit.
  int maxPoints = 0;

  /// Clusters longer than this [m] are clustered again with distances times `splitFactor`.
  /// 0 = never.
  double splitExtent = 20.0;
  double splitFactor = 0.5;

  const char* section() const override { return "objects"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
