// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Track.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace toss {

/// The answer for one return.
enum class PointState : std::uint8_t {
  Invalid,  ///< no valid return: not finite, at the origin, on the robot itself
  Static,   ///< stays
  Moving    ///< belongs to something that moves
};

/// One trace at one scan: a row of tracks.csv.
struct TrackSample {
  TrackId track = 0;
  /// Whether the trace is dynamic.
  bool moving = false;
  /// False where the trace was missed in this scan and the box is predicted.
  bool updated = false;
  /// Map frame, [m].
  Box box;
  /// Map frame, [m/s].
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

/// Labels of one scan, index-aligned with its points.
struct ScanLabels {
  /// PosedScan::index and time [s] of the scan.
  std::uint64_t scan = 0;
  double time = 0.0;
  /// Shape [n].
  std::vector<PointState> state;
  /// Trace (or, where a return has no trace, instance) number of each return, 0 = none, shape [n].
  std::vector<std::uint32_t> track;
  /// Traces alive in this scan, by ascending id.
  std::vector<TrackSample> tracks;
};

}  // namespace toss
