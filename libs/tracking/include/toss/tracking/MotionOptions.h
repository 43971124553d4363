// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// How a trace is found to be dynamic (spec section 6).
enum class MotionRule {
  Tests,   ///< displacement, jitter, path efficiency and both faces, at every detection
  AutoMos  ///< displacement against the longest edge ever seen, at every detection
};

/// Options of the coarse motion class, section [motion].
struct MotionOptions : Options {
  MotionRule rule = MotionRule::Tests;
  /// Detections [scans] and age [s] before a trace can be dynamic.
  int minHits = 4;
  double minAge = 0.4;
  /// Test a: the excursion exceeds extentFactor times the median longer edge, clamped to
  /// [minExcursion, maxExcursion] [m].
  double extentFactor = 1.0, minExcursion = 0.5, maxExcursion = 3.0;
  /// Test b: the excursion exceeds this many standard deviations of the centre's jitter.
  double jitterFactor = 4.0;
  /// Test c: excursion over length of the path.
  double minPathEfficiency = 0.4;
  /// Test d: share of the excursion demanded by test a that front and rear face have both moved by.
  double faceShare = 0.5;
  /// Strong: excursion of at least strongExtentFactor median longer edges and strongExcursion [m],
  /// and strongHits detections.
  double strongExtentFactor = 2.0, strongExcursion = 3.0;
  int strongHits = 8;

  const char* section() const override { return "motion"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
