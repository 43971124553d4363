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
  /// Whether boxes of moving traces claim returns beyond their instances: feet and tyres in the
  /// ground layer, sparse returns, what has melted into a standing instance.
  bool claims = true;
  /// Only traces that are well known do: those seen in so many scans, or of whose cells so large a
  /// share is seen through. Of what was seen once or twice the box is a guess, and often the wrong
  /// thing.
  int claimScans = 5;
  double claimFreeShare = 0.7;
  /// Margin to the sides and top by which they do [m]. What they claim is residue: it is in no map,
  /// and its label is moving where nothing that is static was ever measured in its place.
  double residueMargin = 0.2;
  /// Size of such places [m]: that of the map's voxels, or the next larger of 2 or 4 of them.
  /// 0 = residue moves whatever was measured there.
  double residuePlace = 0.1;
  /// Moving traces also claim what lies on their way in the scans of this time [s] before they were
  /// first seen.
  double hindsightTime = 1.5;

  const char* section() const override { return "decision"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
