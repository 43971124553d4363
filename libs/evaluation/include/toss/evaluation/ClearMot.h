// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace toss {

/// One scan as the scoring of tracks sees it: objects, tracks, and the pairs that may match.
struct TrackingScan {
  /// A pair that passes the gate. `similarity` is larger for better pairs, at least 0.
  struct Pair {
    std::int32_t object = 0, track = 0;
    double similarity = 0.0;
  };
  /// Identities of the objects that have to be tracked, shape [objects], each once.
  std::vector<std::uint64_t> objects;
  /// Identities of what was reported, shape [tracks], each once.
  std::vector<std::uint64_t> tracks;
  /// Whether a track is no false alarm even if it matches nothing (it lies where nothing is
  /// annotated), shape [tracks].
  std::vector<bool> excused;
  /// Indices into `objects` and `tracks`.
  std::vector<Pair> pairs;
};

/// CLEAR MOT (Bernardin and Stiefelhagen 2008). Rates are NaN where there is nothing to count.
struct ClearMot {
  /// Sightings of objects; matches; sightings without a match; tracks without a match.
  std::uint64_t objects = 0, matches = 0, misses = 0, falseAlarms = 0;
  /// Matches of an object with another track than at its last match.
  std::uint64_t identitySwitches = 0;
  /// Times that an object is matched again after sightings without a match.
  std::uint64_t fragmentations = 0;
  /// Sum of the similarities of all matches.
  double similarity = 0.0;
  /// Objects in all; those matched in more than 80 % of their sightings, and in less than 20 %.
  std::uint64_t trajectories = 0, mostlyTracked = 0, mostlyLost = 0;

  /// MOTA = 1 - (misses + false alarms + identity switches) / objects; at most 1.
  double accuracy() const;
  /// MOTP as mean similarity of the matches.
  double precision() const;
  /// Matches / objects.
  double recall() const;
};

/// Confidence of each track, by its identity.
using TrackConfidence = std::map<std::uint64_t, double>;

/// Scores scans in their order. In each, pairs matched before stay matched while they pass the
/// gate; the rest is matched for most pairs and, among those, greatest total similarity. Tracks of
/// a confidence below `threshold` are left out; unknown ones have confidence 0. `matchConfidence`,
/// if given, receives the confidence of every match's track.
ClearMot scoreTracks(const std::vector<TrackingScan>& scans, const TrackConfidence& confidence = {},
                     double threshold = 0.0, std::vector<double>* matchConfidence = nullptr);

/// Accuracy averaged over recall (AB3DMOT, Weng et al. 2020), L = 40 steps of recall.
struct AveragedAccuracy {
  /// AMOTA = 1/L sum of MOTA_r; sAMOTA = 1/L sum of
  /// min(1, max(0, 1 - (FP + FN + IDS - (1 - r) GT) / (r GT))); AMOTP = 1/L sum of MOTP_r. NaN
  /// without objects. Steps of recall that the tracks don't reach add 0.
  double amota = 0.0, samota = 0.0, amotp = 0.0;
};

/// `confidence`: orders the tracks; thresholds are taken from it as AB3DMOT does.
AveragedAccuracy averageAccuracy(const std::vector<TrackingScan>& scans,
                                 const TrackConfidence& confidence);

/// The confidence used where tracks carry no score of their own: number of scans in which the track
/// was reported.
TrackConfidence confidenceByLength(const std::vector<TrackingScan>& scans);

}  // namespace toss
