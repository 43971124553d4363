// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/TrackingOptions.h>

namespace toss {
namespace {

void visitKalman(KalmanOptions& options, OptionVisitor& visitor) {
  visitor.choice({"noise", "", "SI units and real time steps, or AB3DMOT's numbers per scan",
                  "spec section 5.2"},
                 options.noise, {"metric", "paper"});
  visitor.real({"position_sd", "m", "noise of a measured centre; larger smooths more (metric)",
                "spec section 5.2"},
               options.positionSd, 1e-3, 10.0);
  visitor.real({"acceleration_sd", "m/s^2", "how objects accelerate; larger smooths less (metric)",
                "spec section 5.2"},
               options.accelerationSd, 1e-3, 100.0);
  visitor.real({"initial_speed_sd", "m/s",
                "speed of unknown objects; larger trusts the second detection more (metric)",
                "spec section 5.2"},
               options.initialSpeedSd, 0.1, 1000.0);
  visitor.real({"size_sd", "m", "noise of a measured extent; larger smooths more (metric)",
                "spec section 5.2"},
               options.sizeSd, 1e-3, 10.0);
  visitor.real({"size_drift_sd", "m", "change of an extent in 0.1 s; larger smooths less (metric)",
                "spec section 5.2"},
               options.sizeDriftSd, 0.0, 10.0);
  visitor.real({"yaw_sd", "rad", "noise of a measured yaw; larger smooths more (metric)",
                "order of the step of the L-shape search, spec section 4.2"},
               options.yawSd, 1e-3, 10.0);
  visitor.real({"yaw_drift_sd", "rad", "change of yaw in 0.1 s; larger smooths less (metric)",
                "a car turning by 30 degrees per second"},
               options.yawDriftSd, 0.0, 10.0);
}

void visitAssociation(AssociationOptions& options, OptionVisitor& visitor) {
  visitor.choice({"association", "", "which pairs of box and trace are compared",
                  "paper section 3DMOT; automos: spec section 5.5"},
                 options.method, {"hierarchical", "exhaustive", "automos"});
  visitor.choice(
      {"assignment", "", "how pairs that exclude each other are chosen", "spec section 5.6"},
      options.assignment, {"optimal", "greedy", "argmin"});
  visitor.integer({"k", "", "nearest traces that a box is compared with; larger is slower",
                   "paper section 3DMOT, spec section 5.6"},
                  options.candidates, 1, 1000000);
  visitor.real({"max_distance", "m", "largest distance of a box from a prediction",
                "Auto-MOS, spec section 5.5"},
               options.maxDistance, 0.0, 1000.0);
  visitor.real({"min_overlap", "", "least intersection over union with the prediction",
                "Auto-MOS, spec section 5.5"},
               options.minOverlap, 0.0, 1.0);
  visitor.real({"max_volume_cost", "", "largest volume cost 1 - min/max; larger admits more change",
                "Auto-MOS, spec section 5.5"},
               options.maxVolumeCost, 0.0, 1.0);
  visitor.real({"innovation_factor", "", "the distance gate opens to this many standard deviations",
                "spec section 5.5"},
               options.innovationFactor, 0.0, 100.0);
  visitor.real({"max_gate", "m", "the distance gate never opens wider than this",
                "bounds the search; a trace that coasts 0.5 s"},
               options.maxGate, 0.0, 1000.0);
  visitor.real(
      {"min_extent", "m", "least extent in costs and gates; larger lets thin faces move further",
       "spec sections 4.3 and 5.5 (0.1 m); larger for leading cars seen by the rear face"},
      options.minExtent, 1e-3, 10.0);
}

void visitNewborn(NewbornOptions& options, OptionVisitor& visitor) {
  visitor.flag({"newborn", "", "traces seen once look for fast motion where the usual gates fail",
                "spec section 5.5"},
               options.enabled);
  visitor.real({"newborn_base", "m", "reach of that search at zero speed", "spec section 5.5"},
               options.base, 0.0, 100.0);
  visitor.real({"newborn_max_speed", "m/s",
                "fastest object; larger mistakes more clutter for motion", "spec section 5.5"},
               options.maxSpeed, 0.0, 1000.0);
  visitor.real({"newborn_max_time", "s", "longest time that the speed is multiplied with",
                "two scans at 10 Hz"},
               options.maxTime, 0.0, 100.0);
  visitor.real({"newborn_side_ratio", "", "least ratio of each extent", "spec section 5.5"},
               options.minSideRatio, 0.0, 1.0);
  visitor.real({"confirm_base", "m", "how near its prediction the third detection must lie",
                "spec section 5.5"},
               options.confirmBase, 0.0, 100.0);
  visitor.real(
      {"confirm_factor", "", "the same, as share of the predicted step", "spec section 5.5"},
      options.confirmFactor, 0.0, 10.0);
}

void visitLifecycle(LifecycleOptions& options, OptionVisitor& visitor) {
  visitor.choice(
      {"life", "", "misses in a row, or in the whole life, end a trace", "spec section 5.4"},
      options.rule, {"consecutive", "automos"});
  visitor.integer(
      {"min_hits", "scans", "detections until a trace is confirmed", "spec section 5.4"},
      options.minHits, 1, 1000);
  visitor.integer({"max_misses", "scans", "scans without detection that end a trace",
                   "measured on simulated scans; spec section 5.4: 5"},
                  options.maxMisses, 1, 1000);
  visitor.integer({"max_misses_moving", "scans",
                   "scans without detection that end a dynamic trace (life = consecutive)",
                   "measured on simulated scans"},
                  options.maxMissesMoving, 1, 1000);
  visitor.integer({"min_match_points", "returns", "fewest returns of a box that continues a trace",
                   "Auto-MOS, spec section 4.3"},
                  options.minMatchPoints, 1, 1000000);
  visitor.integer({"min_birth_points", "returns", "fewest returns of a box that starts a trace",
                   "spec section 11; section 4.3: 10"},
                  options.minBirthPoints, 1, 1000000);
}

}  // namespace

void TrackingOptions::visit(OptionVisitor& visitor) {
  visitKalman(kalman, visitor);
  visitAssociation(association, visitor);
  visitNewborn(newborn, visitor);
  visitLifecycle(lifecycle, visitor);
}

}  // namespace toss
