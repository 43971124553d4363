// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/ClearMot.h>
#include <toss/tracking/OptimalAssignment.h>

#include <limits>

namespace toss {
namespace {

/// What is remembered of an object from scan to scan.
struct Trajectory {
  std::uint64_t sightings = 0, matches = 0;
  std::uint64_t lastTrack = 0;
  bool matchedBefore = false, missedSince = false;
};

double ratio(double part, std::uint64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : part / static_cast<double>(whole);
}

double confidenceOf(std::uint64_t track, const TrackConfidence& confidence) {
  const auto found = confidence.find(track);
  return found == confidence.end() ? 0.0 : found->second;
}

/// Scores one scan after the other.
class Scorer {
 public:
  Scorer(const TrackConfidence& confidence, double threshold, std::vector<double>* matchConfidence)
      : confidence_(confidence), threshold_(threshold), matchConfidence_(matchConfidence) {}

  void add(const TrackingScan& scan) {
    select(scan);
    keepMatches(scan);
    matchRest(scan);
    countObjects(scan);
    countFalseAlarms(scan);
  }

  ClearMot result() {
    for (const auto& [id, t] : trajectories_) {
      ++score_.trajectories;
      score_.mostlyTracked += 5 * t.matches > 4 * t.sightings;
      score_.mostlyLost += 5 * t.matches < t.sightings;
    }
    return score_;
  }

 private:
  void select(const TrackingScan& scan) {
    pairOfObject_.assign(scan.objects.size(), nullptr);
    trackTaken_.assign(scan.tracks.size(), false);
    trackUsed_.resize(scan.tracks.size());
    for (std::size_t t = 0; t < scan.tracks.size(); ++t) {
      trackUsed_[t] = confidenceOf(scan.tracks[t], confidence_) >= threshold_;
    }
  }

  bool available(const TrackingScan::Pair& pair) const {
    const auto object = static_cast<std::size_t>(pair.object);
    const auto track = static_cast<std::size_t>(pair.track);
    return !pairOfObject_[object] && trackUsed_[track] && !trackTaken_[track];
  }

  void match(const TrackingScan::Pair& pair) {
    pairOfObject_[static_cast<std::size_t>(pair.object)] = &pair;
    trackTaken_[static_cast<std::size_t>(pair.track)] = true;
  }

  void keepMatches(const TrackingScan& scan) {
    for (const TrackingScan::Pair& pair : scan.pairs) {
      const auto known = trajectories_.find(scan.objects[static_cast<std::size_t>(pair.object)]);
      if (known == trajectories_.end() || !known->second.matchedBefore) continue;
      const std::uint64_t track = scan.tracks[static_cast<std::size_t>(pair.track)];
      if (known->second.lastTrack == track && available(pair)) match(pair);
    }
  }

  void matchRest(const TrackingScan& scan) {
    CostMatrix costs(static_cast<int>(scan.objects.size()), static_cast<int>(scan.tracks.size()),
                     std::numeric_limits<double>::infinity());
    for (const TrackingScan::Pair& pair : scan.pairs) {
      if (available(pair)) costs.at(pair.object, pair.track) = -pair.similarity;
    }
    const std::vector<std::int32_t> trackOfObject = solveGatedAssignment(costs);
    for (const TrackingScan::Pair& pair : scan.pairs) {
      if (available(pair) && trackOfObject[static_cast<std::size_t>(pair.object)] == pair.track) {
        match(pair);
      }
    }
  }

  void countObjects(const TrackingScan& scan) {
    for (std::size_t o = 0; o < scan.objects.size(); ++o) {
      Trajectory& trajectory = trajectories_[scan.objects[o]];
      ++score_.objects, ++trajectory.sightings;
      if (pairOfObject_[o]) {
        countMatch(scan, *pairOfObject_[o], trajectory);
      } else {
        ++score_.misses;
        trajectory.missedSince = true;
      }
    }
  }

  void countMatch(const TrackingScan& scan, const TrackingScan::Pair& pair,
                  Trajectory& trajectory) {
    const std::uint64_t track = scan.tracks[static_cast<std::size_t>(pair.track)];
    ++score_.matches, ++trajectory.matches;
    score_.similarity += pair.similarity;
    score_.identitySwitches += trajectory.matchedBefore && trajectory.lastTrack != track;
    score_.fragmentations += trajectory.matchedBefore && trajectory.missedSince;
    trajectory.lastTrack = track;
    trajectory.matchedBefore = true, trajectory.missedSince = false;
    if (matchConfidence_) matchConfidence_->push_back(confidenceOf(track, confidence_));
  }

  void countFalseAlarms(const TrackingScan& scan) {
    for (std::size_t t = 0; t < scan.tracks.size(); ++t) {
      score_.falseAlarms += trackUsed_[t] && !trackTaken_[t] && !scan.excused[t];
    }
  }

  const TrackConfidence& confidence_;
  double threshold_;
  std::vector<double>* matchConfidence_;
  ClearMot score_;
  std::map<std::uint64_t, Trajectory> trajectories_;
  std::vector<const TrackingScan::Pair*> pairOfObject_;
  std::vector<bool> trackTaken_, trackUsed_;
};

}  // namespace

double ClearMot::accuracy() const {
  const std::uint64_t errors = misses + falseAlarms + identitySwitches;
  return 1.0 - ratio(static_cast<double>(errors), objects);
}
double ClearMot::precision() const {
  return ratio(similarity, matches);
}
double ClearMot::recall() const {
  return ratio(static_cast<double>(matches), objects);
}

ClearMot scoreTracks(const std::vector<TrackingScan>& scans, const TrackConfidence& confidence,
                     double threshold, std::vector<double>* matchConfidence) {
  Scorer scorer(confidence, threshold, matchConfidence);
  for (const TrackingScan& scan : scans) scorer.add(scan);
  return scorer.result();
}

TrackConfidence confidenceByLength(const std::vector<TrackingScan>& scans) {
  TrackConfidence confidence;
  for (const TrackingScan& scan : scans) {
    for (const std::uint64_t track : scan.tracks) confidence[track] += 1.0;
  }
  return confidence;
}

}  // namespace toss
