// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Options.h>

namespace toss {

/// Which set of noise parameters the Kalman filters use (spec section 5.2).
enum class KalmanNoiseModel {
  Metric,  ///< SI units and the real time between scans
  Paper    ///< AB3DMOT's numbers: metres per scan, whatever the time between scans
};

/// Noise of the constant-velocity filters. Only `Metric` has parameters.
struct KalmanOptions {
  KalmanNoiseModel noise = KalmanNoiseModel::Metric;
  /// Standard deviation of a measured centre [m], and of the acceleration [m/s^2].
  double positionSd = 0.15, accelerationSd = 3.0;
  /// Standard deviation of the velocity of a trace that has been seen once [m/s].
  double initialSpeedSd = 15.0;
  /// Standard deviation of a measured extent [m], and of its change within 0.1 s [m].
  double sizeSd = 0.2, sizeDriftSd = 0.05;
  /// Standard deviation of a measured yaw [rad], and of its change within 0.1 s [rad].
  double yawSd = 0.1, yawDriftSd = 0.05;
};

/// How candidate pairs are found (paper section 3DMOT).
enum class AssociationMethod {
  Hierarchical,  ///< the k nearest traces of each box
  Exhaustive,    ///< every box with every trace, same gates
  AutoMos        ///< every box with every trace, each violated gate costing 1e8 (spec section 5.5)
};

/// How a box gets one of its candidates (spec section 5.6).
enum class AssignmentMethod {
  Optimal,  ///< most pairs, and among those the least total cost
  Greedy,   ///< cheapest pair first
  Argmin    ///< each box its cheapest trace; of two boxes with one trace the cheaper gets it
};

/// Costs, gates and the choice among the pairs that pass them.
struct AssociationOptions {
  AssociationMethod method = AssociationMethod::Hierarchical;
  AssignmentMethod assignment = AssignmentMethod::Optimal;
  /// Candidates per box: k of the paper.
  int candidates = 5;
  /// Gates of a pair: largest centre distance [m], least overlap, largest volume cost.
  double maxDistance = 2.0, minOverlap = 0.05, maxVolumeCost = 0.7;
  /// The distance gate opens to this many standard deviations of the innovation, up to
  /// `maxGate` [m].
  double innovationFactor = 3.0, maxGate = 5.0;
  /// Extents count as at least this [m] in costs and gates: a thin face that moves by more than its
  /// thickness still overlaps its prediction.
  double minExtent = 0.5;
};

/// How traces that have been seen once are found again although their speed is unknown
/// (spec section 5.5). Tried for what the usual gates have left over.
struct NewbornOptions {
  bool enabled = true;
  /// Reach of the gate [m]: base + maxSpeed [m/s] * time since the detection, at most `maxTime`
  /// [s].
  double base = 0.5, maxSpeed = 35.0, maxTime = 0.25;
  /// Least ratio of corresponding extents.
  double minSideRatio = 0.5;
  /// The third detection must lie within base [m] + factor * predicted step of the prediction, or
  /// the trace ends.
  double confirmBase = 1.0, confirmFactor = 0.2;
};

/// When a trace ends (spec section 5.4).
enum class LifeRule {
  Consecutive,  ///< at the maxMisses-th scan in a row without detection
  AutoMos       ///< at the maxMisses-th scan without detection in its whole life
};

/// Birth and death of traces.
struct LifecycleOptions {
  LifeRule rule = LifeRule::Consecutive;
  /// Detections until a trace is confirmed; scans without detection until it ends.
  int minHits = 3, maxMisses = 10;
  /// The latter for dynamic traces: who passes behind something or merges with somebody comes back.
  int maxMissesMoving = 30;
  /// Fewest returns of a box that may continue a trace, and of one that may start a trace.
  int minMatchPoints = 3, minBirthPoints = 3;
};

/// Options of the multi-object tracker, section [tracking].
struct TrackingOptions : Options {
  KalmanOptions kalman;
  AssociationOptions association;
  NewbornOptions newborn;
  LifecycleOptions lifecycle;

  const char* section() const override { return "tracking"; }
  void visit(OptionVisitor& visitor) override;
};

}  // namespace toss
