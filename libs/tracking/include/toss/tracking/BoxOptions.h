// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// Which way the box of an instance lies (spec section 4.2).
enum class BoxMode {
  AxisAligned,  ///< along the axes of the map: what the paper's b_G is (spec section 4.1)
  LShape        ///< along the sides of the rectangle that the returns outline
};

/// Options of the boxes around instances, section [boxes].
struct BoxOptions : Options {
  BoxMode mode = BoxMode::AxisAligned;
  /// Share of the returns cut off at each end of each axis, in instances of more than `trimPoints`
  /// returns: 0 is the paper's minimum and maximum, 0.01 the 1 % and 99 % quantiles.
  double trim = 0.0;
  int trimPoints = 200;
  /// The lower face goes down to the ground if that is no farther than this [m], so that what
  /// hides the feet of an object does not lift its centre. 0 = never.
  double floorGap = 0.3;

  /// An L-shape is fitted to instances of at least this many returns ...
  int lShapePoints = 30;
  /// ... whose longer axis-aligned side is within these bounds [m]. Others are axis-aligned.
  double lShapeMinSide = 1.2, lShapeMaxSide = 12.0;

  /// Instances longer or wider than this [m] are background.
  double maxExtent = 20.0;
  /// Instances higher than `maxHeight` [m] with a footprint above `maxFootprint` [m^2] are
  /// background: buildings and trees, while trucks and buses are lower.
  double maxHeight = 4.5, maxFootprint = 15.0;
  /// Instances that begin higher than this above ground [m] are background: crowns, signs, bridges.
  /// No views are asked about them, nor about lone returns as high; 10000 for both everywhere.
  double maxClearance = 2.5;

  const char* section() const override { return "boxes"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
