// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

namespace toss {

/// The three terms of the association cost (paper section 3DMOT).
struct AssociationCost {
  /// c_d = |c_i - c_j| [m], in three dimensions.
  double distance = 0.0;
  /// c_o = 1 - IoU of the volumes.
  double overlap = 0.0;
  /// c_v = 1 - min(v_i, v_j) / max(v_i, v_j).
  double volume = 0.0;

  /// C = c_d + c_o + c_v.
  double total() const { return distance + overlap + volume; }
};

/// c_v of two boxes; 1 where only one has no volume, 0 where neither has.
double volumeCost(const Box& a, const Box& b);

/// All three terms.
AssociationCost associationCost(const Box& a, const Box& b);

/// The box with every extent at least `minExtent` [m] (spec sections 4.3 and 5.5).
Box withMinExtent(const Box& box, double minExtent);

}  // namespace toss
