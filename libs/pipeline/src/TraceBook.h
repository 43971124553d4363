// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Track.h>
#include <toss/visibility/EvidenceCells.h>
#include <toss/voting/FusedDecision.h>

#include <deque>

namespace toss {

/// What is known of every trace, for as long as a scan in which it was seen is not settled.
class TraceBook {
 public:
  TraceBook(const DecisionOptions& options, bool awaitEvidence)
      : options_(options), liveOptions_(options), awaitEvidence_(awaitEvidence) {
    liveOptions_.traceFreeShare = options.liveFreeShare;
    unknown_.live = fuseTrace(unknown_.motion, {}, {}, liveOptions_);
    unknown_.final = fuseTrace(unknown_.motion, {}, {}, options_);
  }

  /// Takes over the coarse class that tracking has come to.
  void setMotion(TrackId track, MotionClass motion);
  /// Counts one more scan in which the trace was seen.
  void addSighting(TrackId track) { ++verdicts_[placeOf(track)].sightings; }
  /// Adds what past views say of one more instance of the trace (live), and what all views say
  /// (final); `fast`: the trace was about to leave its place.
  void addPast(TrackId track, const FreeSpaceSum& evidence);
  void addFinal(TrackId track, const FreeSpaceSum& evidence, bool fast = false);

  /// Class with no look-ahead.
  MotionClass liveClass(TrackId track) const;
  /// Class for the final labels. A weak motion waits for its evidence unless `last` says that no
  /// more will come.
  MotionClass finalClass(TrackId track, bool last) const;
  /// Whether the trace may turn out to be dynamic; `last`: as above.
  bool mayMove(TrackId track, bool last) const;
  /// Whether it may, and is well known.
  bool mayClaim(TrackId track, bool last) const;

  /// Forgets traces whose number is below `track`.
  void forgetBelow(TrackId track);

 private:
  struct Evidence {
    FreeSpaceSum past, all, whileFast;
  };
  /// The coarse class, and what is fused from it and the evidence: asked for more often than it
  /// changes.
  struct Verdict {
    MotionClass motion = MotionClass::Static;
    MotionClass live = MotionClass::Static, final = MotionClass::Static;
    int sightings = 0, scansWithEvidence = 0;
  };
  /// Place of a trace, made where there is none yet.
  std::size_t placeOf(TrackId track);
  const Verdict* find(TrackId track) const;
  void fuseFinal(std::size_t place);

  DecisionOptions options_, liveOptions_;
  bool awaitEvidence_;
  /// Of a trace of which nothing has been told.
  Verdict unknown_;
  /// The trace at place 0.
  TrackId first_ = 1;
  std::deque<Evidence> evidence_;
  std::deque<Verdict> verdicts_;
};

}  // namespace toss
