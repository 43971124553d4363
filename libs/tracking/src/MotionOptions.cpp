// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionOptions.h>

namespace toss {

void MotionOptions::visit(OptionVisitor& visitor) {
  visitor.choice({"rule", "", "how a trace is found to move", "spec section 6; automos: Auto-MOS"},
                 rule, {"tests", "automos"});
  visitor.integer(
      {"min_hits", "scans", "detections before a trace can be dynamic", "spec section 6"}, minHits,
      2, 1000);
  visitor.real({"min_age", "s", "age before a trace can be dynamic", "spec section 6"}, minAge, 0.0,
               100.0);
  visitor.real({"extent_factor", "", "excursion demanded, in longer edges of the box",
                "paper section 3DMOT, spec section 6"},
               extentFactor, 0.0, 100.0);
  visitor.real(
      {"min_excursion", "m", "excursion demanded of the smallest objects", "spec section 6"},
      minExcursion, 0.0, 100.0);
  visitor.real(
      {"max_excursion", "m", "excursion demanded of the largest objects", "spec section 6"},
      maxExcursion, 0.0, 1000.0);
  visitor.real({"jitter_factor", "", "excursion demanded, in standard deviations of the centre",
                "spec section 6"},
               jitterFactor, 0.0, 100.0);
  visitor.real(
      {"min_path_efficiency", "", "least share of the path that is excursion", "spec section 6"},
      minPathEfficiency, 0.0, 1.0);
  visitor.real({"face_share", "",
                "how far both faces must have moved, in demanded excursions; larger rejects more "
                "views that merely grow",
                "spec section 6"},
               faceShare, 0.0, 1.0);
  visitor.real(
      {"strong_extent_factor", "", "excursion of strong traces, in longer edges", "spec section 6"},
      strongExtentFactor, 0.0, 100.0);
  visitor.real({"strong_excursion", "m", "excursion of strong traces at least", "spec section 6"},
               strongExcursion, 0.0, 1000.0);
  visitor.integer(
      {"strong_hits", "scans", "detections of strong traces at least", "spec section 6"},
      strongHits, 2, 1000);
}

}  // namespace toss
