// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <Eigen/Core>
#include <cstdint>

namespace toss {

/// Identity of a trace, counted from 1 over the whole run and never given twice; 0 = no trace.
using TrackId = std::uint64_t;

/// Coarse class of a trace (spec section 6): dynamic traces are Weak or Strong. Strong ones have
/// travelled so far that voting may not return them to static (spec section 7.3). Doubtful ones
/// advance, but were mostly seen past something nearer, or scatter much: people behind bushes move
/// like this, and so do patches of wall seen between parked cars. Only free space can tell.
enum class MotionClass : std::uint8_t { Static, Doubtful, Weak, Strong };

inline bool isDynamic(MotionClass motion) {
  return motion == MotionClass::Weak || motion == MotionClass::Strong;
}

/// A trace as it stands after the last scan.
struct Track {
  TrackId id = 0;
  /// Estimated box, map frame; predicted where `updated` is false.
  Box box;
  /// Estimated velocity of the centre [m/s], map frame.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  /// Time of the first detection [s], and of the estimate [s].
  double birthTime = 0.0, time = 0.0;
  /// Detections in all, scans in a row without one, and scans without one in the whole life.
  int hits = 0, misses = 0, totalMisses = 0;
  /// Whether it has had enough detections to count as a trace (TrackingOptions::lifecycle.minHits).
  bool confirmed = false;
  /// Index of the detection of the last scan, -1 where it was missed.
  std::int32_t detection = -1;
  /// Coarse class; rises in the order of MotionClass, never falls.
  MotionClass motion = MotionClass::Static;

  /// Evidence for later stages, all from detections, horizontal [m]: largest distance of the
  /// estimated centre from its first place, length of its path, median of the longer edge.
  double excursion = 0.0, pathLength = 0.0, medianExtent = 0.0;

  bool updated() const { return detection >= 0; }
  double speed() const { return velocity.head<2>().norm(); }
};

}  // namespace toss
