// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How motion, votes and free space become one verdict, section [decision] (spec section 12).
struct DecisionOptions : Options {
  /// An instance of which this share is seen through moves, whatever its trace did.
  double freeShare = 0.4;
  /// The same for a trace, over all its instances.
  double traceFreeShare = 0.3;
  /// A trace that moved weakly counts as Strong from this share on: both kinds of evidence agree.
  double confirmFreeShare = 0.15;
  /// Share for the live label, where only past views testify.
  double liveFreeShare = 0.35;
  /// What was measured again by this share and seen through by less than that stays, however its
  /// trace moved.
  double vetoHitShare = 0.5, vetoFreeShare = 0.05;
  /// A trace whose motion is doubtful moves if this share of its cells is glimpsed past.
  double doubtfulGlimpsedShare = 0.25;
  /// Cells that must be seen through for the free share to count.
  int minCells = 2;
  /// Free views that make a return without an instance move on its own.
  int loneFreeViews = 4;
  /// Whether boxes of traces claim returns that have no instance: feet and tyres in the ground
  /// layer, sparse returns.
  bool claims = true;
  /// Margin by which the box of a trace claims returns that have no instance, and cuts those of
  /// standing instances [m].
  double claimMargin = 0.15;
  /// Margin by which the box of a moving trace holds residue: ground, and what stands close beside
  /// it [m]. Residue moves where nothing that is static was ever measured in its place, see
  /// StaticMap::holds(). 0 = there is no residue.
  double residueMargin = 0.2;
  /// An instance with fewer returns than this that lies in the box of a trace moves with it, unless
  /// it is clearly measured again.
  int fragmentPoints = 15;
  /// When a scan enters the map, traces that are known to move by then claim, as residue, what
  /// their boxes hold, and what lies on their way in the scans of this time [s] before they were
  /// first seen; 0 = no such claims. Needs `claims`, a residue margin and voxels.
  double hindsightTime = 1.5;

  const char* section() const override { return "decision"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
