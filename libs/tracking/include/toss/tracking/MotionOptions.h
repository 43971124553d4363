// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How a trace is found to be dynamic (spec section 6).
enum class MotionRule {
  Tests,   ///< the front and the rear face advance together, far enough and steadily
  AutoMos  ///< displacement against the longest edge ever seen; paper to the letter
};

/// Options of the coarse motion class, section [motion]. The tests look at the detections of the
/// last `window` seconds, so that a car that waited for a minute is judged by how it leaves.
/// Wherever the spec's default is changed, real scans asked for it: with its defaults three of four
/// traces called moving there were facade, hedge and ground.
struct MotionOptions : Options {
  MotionRule rule = MotionRule::Tests;
  /// Time that the tests look back [s].
  double window = 4.0;
  /// Detections in the window [scans] and their time span [s] before a trace can be dynamic.
  int minHits = 6;
  double minAge = 0.4;
  /// Least median height and longer edge [m]: traces of ground and kerbs move along with the
  /// sensor's rings, those of single columns of a wall seen at a grazing angle with its columns.
  /// From half of them on, motion is doubtful: the head of somebody behind a hedge.
  double minHeight = 0.3, minExtent = 0.2;
  /// Test a: the displacement exceeds extentFactor times the median longer edge, clamped to
  /// [minExcursion, maxExcursion] [m].
  double extentFactor = 1.0, minExcursion = 0.5, maxExcursion = 6.0;
  /// Test b: the displacement exceeds this many times the scatter of the faces about their lines.
  double jitterFactor = 10.0;
  /// The same for a doubtful motion, which needs free space to confirm it.
  double doubtfulJitterFactor = 3.0;
  /// Test c: displacement over length of the path.
  double minPathEfficiency = 0.4;
  /// Test d: both faces have moved by faceShare times the displacement demanded by test a, and the
  /// lagging one by faceRatio times the leading one.
  double faceShare = 0.5, faceRatio = 0.75;
  /// Largest mean share of the outline that something nearer hides; beyond it, motion is doubtful.
  /// What is seen through a window or between parked cars wanders as the sensor passes.
  double maxHidden = 0.45;
  /// Strong: excursion of at least strongExtentFactor median longer edges and strongExcursion [m],
  /// strongHits detections, and test b with strongJitterFactor.
  double strongExtentFactor = 2.0, strongExcursion = 3.0, strongJitterFactor = 15.0;
  int strongHits = 8;

  const char* section() const override { return "motion"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
