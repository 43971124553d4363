// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/MotionOptions.h>

namespace toss {
namespace {

void visitTests(MotionOptions& options, OptionVisitor& visitor) {
  visitor.real({"window", "s", "time the tests look back; larger finds slower objects",
                "measured on real scans"},
               options.window, 0.1, 1000.0);
  visitor.real(
      {"strong_jitter_factor", "", "displacement of strong traces, in scatters of the faces",
       "measured on real scans"},
      options.strongJitterFactor, 0.0, 1000.0);
  visitor.integer({"min_hits", "scans", "detections in the window before a trace can be dynamic",
                   "measured on real scans; spec section 6: 4"},
                  options.minHits, 3, 1000);
  visitor.real({"min_age", "s", "time span of the detections before a trace can be dynamic",
                "spec section 6"},
               options.minAge, 0.0, 1000.0);
  visitor.real({"min_height", "m",
                "least median height, half of it for a doubtful motion; larger rejects more ground "
                "and kerbs",
                "measured on real scans"},
               options.minHeight, 0.0, 100.0);
  visitor.real({"min_extent", "m",
                "least median longer edge, half of it for a doubtful motion; larger rejects more "
                "walls seen at grazing angles",
                "measured on simulated scans"},
               options.minExtent, 0.0, 100.0);
  visitor.real({"extent_factor", "", "displacement demanded, in longer edges of the box",
                "paper section 3DMOT, spec section 6"},
               options.extentFactor, 0.0, 100.0);
  visitor.real(
      {"min_excursion", "m", "displacement demanded of the smallest objects", "spec section 6"},
      options.minExcursion, 0.0, 100.0);
  visitor.real({"max_excursion", "m", "displacement demanded of the largest objects",
                "measured on real scans; spec section 6: 3"},
               options.maxExcursion, 0.0, 1000.0);
  visitor.real({"jitter_factor", "",
                "displacement demanded, in scatters of the faces about their lines; larger rejects "
                "more vegetation",
                "measured on real scans; spec section 6: 4, of the filter's deviation"},
               options.jitterFactor, 0.0, 1000.0);
  visitor.real({"doubtful_jitter_factor", "",
                "the same for a doubtful motion, which free space must confirm",
                "measured on simulated scans"},
               options.doubtfulJitterFactor, 0.0, 1000.0);
  visitor.real(
      {"min_path_efficiency", "", "least share of the path that is displacement", "spec section 6"},
      options.minPathEfficiency, 0.0, 1.0);
  visitor.real(
      {"face_share", "", "least motion of both faces, in demanded displacements", "spec section 6"},
      options.faceShare, 0.0, 1.0);
  visitor.real({"face_ratio", "",
                "least motion of the lagging face, as share of the leading one's; larger rejects "
                "more views that merely grow",
                "measured on real scans"},
               options.faceRatio, 0.0, 1.0);
  visitor.real({"max_hidden", "",
                "largest share of the outline that something nearer hides; smaller rejects more "
                "views through openings",
                "measured on real scans, spec section 3.5"},
               options.maxHidden, 0.0, 1.0);
}

void visitStrong(MotionOptions& options, OptionVisitor& visitor) {
  visitor.real(
      {"strong_extent_factor", "", "excursion of strong traces, in longer edges", "spec section 6"},
      options.strongExtentFactor, 0.0, 100.0);
  visitor.real({"strong_excursion", "m", "excursion of strong traces at least", "spec section 6"},
               options.strongExcursion, 0.0, 1000.0);
  visitor.integer(
      {"strong_hits", "scans", "detections of strong traces at least", "spec section 6"},
      options.strongHits, 2, 1000);
}

}  // namespace

void MotionOptions::visit(OptionVisitor& visitor) {
  visitor.choice({"rule", "", "how a trace is found to move", "spec section 6; automos: Auto-MOS"},
                 rule, {"tests", "automos"});
  visitTests(*this, visitor);
  visitStrong(*this, visitor);
}

}  // namespace toss
