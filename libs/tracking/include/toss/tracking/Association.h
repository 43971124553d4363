// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>
#include <toss/tracking/TrackingOptions.h>

#include <cstdint>
#include <tuple>
#include <vector>

namespace toss {

/// A trace as association sees it.
struct AssociationTarget {
  /// Box predicted to the time of the scan, map frame, extents floored.
  Box predicted;
  /// Largest centre distance [m] of a box that may continue the trace.
  double reach = 0.0;
};

/// What a pair must fulfil beside the target's reach.
struct AssociationGates {
  /// Least intersection over union; 0 admits pairs that do not touch.
  double minOverlap = 0.0;
  /// Largest volume cost.
  double maxVolumeCost = 1.0;
  /// Least ratio of the smaller to the larger of each pair of corresponding extents.
  double minSideRatio = 0.0;
};

/// The boxes of one scan and the traces that they may continue.
struct AssociationProblem {
  /// Boxes, map frame, extents floored.
  std::vector<Box> detections;
  /// Traces, oldest first: of equal candidates the older one wins.
  std::vector<AssociationTarget> targets;
  AssociationGates gates;
};

/// An admissible pair of a box and a trace, or one that has been chosen.
struct AssociationPair {
  /// Indices in the problem.
  std::int32_t detection = -1, target = -1;
  /// C of the paper, and its term c_d [m].
  double cost = 0.0, distance = 0.0;

  /// The order in which pairs are preferred: it leaves no ties.
  bool operator<(const AssociationPair& other) const {
    return std::tie(cost, distance, target, detection) <
           std::tie(other.cost, other.distance, other.target, other.detection);
  }
};

/// Whether the pair passes all gates; then `pair` gets its cost.
bool isAdmissible(const AssociationProblem& problem, std::int32_t detection, std::int32_t target,
                  AssociationPair& pair);

/// The chosen pairs by ascending detection; each detection and each target at most once. Method and
/// assignment as the options say.
std::vector<AssociationPair> associate(const AssociationProblem& problem,
                                       const AssociationOptions& options);

}  // namespace toss
