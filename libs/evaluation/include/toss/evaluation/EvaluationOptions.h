// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// What becomes of points whose true label is 0 (not annotated).
enum class Unlabelled {
  Auto,    ///< Ignore where more than half of all points are not annotated, else Static
  Static,  ///< count as static, as ERASOR's scripts do on SemanticKITTI
  Ignore   ///< leave them out of the truth and of what is scored
};

/// How a reported box is held against a true one.
enum class BoxMatch {
  Distance,  ///< horizontal distance of the centres, as nuScenes does
  Overlap    ///< intersection over union of the volumes, as AB3DMOT does
};

/// Options of the evaluation, section "evaluation" (spec section 9).
struct EvaluationOptions : Options {
  /// Edge of the voxels in which PR and RR are counted [m].
  double voxelSize = 0.2;
  /// Points horizontally nearer to the sensor than this [m] are in neither map: the car itself.
  double egoRadius = 2.7;
  /// What becomes of points that are not annotated.
  Unlabelled unlabelled = Unlabelled::Auto;
  /// Counts class 258 (moving truck) as static, as two public scripts do.
  bool omitTruckClass = false;
  /// First and last scan index that is scored; last < 0: up to the end.
  int from = 0, to = -1;
  /// Every how manieth scan from `from` on is scored.
  int stride = 1;
  /// SA and DA: a point counts as removed where the nearest point kept is farther than this [m].
  double removalDistance = 0.05;
  /// SA and DA: points farther from the sensor than this [m] are left out.
  double removalRange = 50.0;
  /// SA and DA: unlabelled points and outliers nearer than this [m] count as moving.
  double removalEgoRange = 3.0;
  /// Whether the oracle bounds are computed: about doubles the run time.
  bool bounds = true;
  /// Objects with fewer returns in a scan are not asked of the tracker there, and tracks with fewer
  /// are no false alarms.
  int trackingMinReturns = 10;
  /// Least intersection over union of the returns of a track with those of an object.
  double trackingOverlap = 0.5;
  /// How boxes are matched, with the largest distance [m] or the least overlap.
  BoxMatch boxMatch = BoxMatch::Distance;
  double boxDistance = 2.0, boxOverlap = 0.25;

  const char* section() const override { return "evaluation"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
