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
  double nearFactor = 0.4, farFactor = 2.0;
  /// The adaptive distance is range times this angle [rad], within a row and between rows. It
  /// counts as at least 2.5 columns and one row of the sensor.
  double horizontalAngle = 0.019, verticalAngle = 0.022;
  /// Rows that a link may reach up or down [rows].
  int rowWindow = 3;
  /// Greatest difference in height [m] of returns linked across at least one row in between.
  double maxHeightGap = 1.0;
  /// Returns of neighbouring pixels in neighbouring rows, both lower than the sensor by
  /// `surfaceDepth` [m], are linked up to this horizontal distance [m]: the beams graze bonnets and
  /// windscreens there, and their rows lie far apart on them. 0 = no such links.
  double surfaceDistance = 0.5, surfaceDepth = 0.5;

  /// Returns of one pixel whose ranges differ less [m] are one surface.
  double pixelMerge = 0.3;
  /// A return left over by clustering is given to an instance that is this near [m]; 0 = never.
  double attachDistance = 0.5;

  /// Fewest returns of an instance: as many as a surface of `minSize` x `minSize` [m] catches at
  /// that range, but at least `minPointsFar` and at most `minPointsNear`.
  int minPointsNear = 2, minPointsFar = 2;
  double minSize = 0.3;
  /// Most returns of an instance; clusters above it stay without instance. 0 = no limit.
  int maxPoints = 0;

  /// Clusters longer than this [m] are clustered again with distances times `splitFactor`; parts
  /// with fewer returns than a surface of `splitMinSize` x `splitMinSize` [m] catches stay with the
  /// rest. 0 = never.
  double splitExtent = 6.0;
  double splitFactor = 0.5;
  double splitMinSize = 0.3;

  const char* section() const override { return "objects"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
