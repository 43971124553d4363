// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/ClearMot.h>
#include <toss/evaluation/LossCauses.h>
#include <toss/evaluation/MovingScores.h>
#include <toss/evaluation/PreservationRejection.h>
#include <toss/evaluation/RemovalAccuracy.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// Scores of one static map.
struct MapReport {
  PreservationRejection rates;
  LossTable losses;
  /// Absent where it was not asked for (live labels).
  std::optional<RemovalAccuracy> removal;
};

/// Scores of tracks against objects.
struct TrackingReport {
  ClearMot clear;
  /// Confidence of a track: the number of scans in which it was reported.
  AveragedAccuracy averaged;
};

/// What an oracle would reach, by the name of what it may decide on: every group is moving or
/// static as the majority of its true labels, returns in no group stay. A run that judges such
/// returns one by one can do better than the bound.
struct BoundReport {
  std::string name;
  PreservationRejection rates;
  LossTable losses;
};

/// Wall time of one stage over the scans [ms].
struct StageTime {
  std::string stage;
  std::uint64_t scans = 0;
  double mean = 0.0, median = 0.0, percentile95 = 0.0, largest = 0.0;
};

/// Everything that `toss eval` has found out. Parts that the run gives no data for are absent.
struct EvaluationReport {
  /// Paths as they were given.
  std::string truth, run;
  /// Scans and returns that were scored; scans without true labels, and without labels of the run.
  std::uint64_t scans = 0, points = 0, scansWithoutTruth = 0, scansWithoutLabels = 0;
  /// Whether true class 0 was left out, and the voxel size [m].
  bool unlabelledIgnored = false;
  double voxelSize = 0.0;

  /// Map of the labels: every return called static, in ERASOR's voxels. Final and live labels.
  std::optional<MapReport> labels, liveLabels;
  /// Map of the file (static_map.ply or another program's); true labels as MapTruth gives them. A
  /// map of voxels larger than the removal distance loses static accuracy by its making.
  std::optional<MapReport> map;
  /// Points of the map file, and of them those that no return is near.
  std::uint64_t mapPoints = 0, mapPointsWithoutReturn = 0;

  /// Points called moving, by final and by live labels.
  std::optional<MovingScores> moving, liveMoving;
  /// Tracks by the instance numbers of the labels, and by boxes.
  std::optional<TrackingReport> tracking, boxTracking;
  std::vector<BoundReport> bounds;
  std::vector<StageTime> stages;
  /// Threads, processor and version as the run's resources.json and summary.json tell; "" where
  /// they do not.
  std::string threads, processor, version;
  /// What the run took as its resources.json tells [s, scans/s, bytes]; 0 where it does not.
  double wallSeconds = 0.0, processorSeconds = 0.0, scansPerSecond = 0.0, peakMemoryBytes = 0.0;
  /// Plain sentences for the user.
  std::vector<std::string> warnings;
};

/// JSON with keys in a fixed order; undefined rates are null. Same report, same bytes.
std::string toJson(const EvaluationReport& report);
/// A table for the terminal.
std::string toText(const EvaluationReport& report);

}  // namespace toss
