// SPDX-License-Identifier: BSD-3-Clause
#include "TraceBook.h"

namespace toss {

std::size_t TraceBook::placeOf(TrackId track) {
  while (first_ + verdicts_.size() <= track) {
    evidence_.emplace_back();
    verdicts_.push_back(unknown_);
  }
  return static_cast<std::size_t>(track - first_);
}

const TraceBook::Verdict* TraceBook::find(TrackId track) const {
  if (track < first_ || track >= first_ + verdicts_.size()) return nullptr;
  return &verdicts_[static_cast<std::size_t>(track - first_)];
}

void TraceBook::setMotion(TrackId track, MotionClass motion) {
  const std::size_t place = placeOf(track);
  Verdict& verdict = verdicts_[place];
  if (verdict.motion == motion) return;
  verdict.motion = motion;
  verdict.live = fuseTrace(motion, evidence_[place].past, {}, liveOptions_);
  fuseFinal(place);
}

void TraceBook::addPast(TrackId track, const FreeSpaceSum& evidence) {
  const std::size_t place = placeOf(track);
  FreeSpaceSum& past = evidence_[place].past;
  past.add(evidence);
  verdicts_[place].live = fuseTrace(verdicts_[place].motion, past, {}, liveOptions_);
}

void TraceBook::addFinal(TrackId track, const FreeSpaceSum& evidence, bool fast) {
  const std::size_t place = placeOf(track);
  evidence_[place].all.add(evidence);
  if (fast) evidence_[place].whileFast.add(evidence);
  ++verdicts_[place].scansWithEvidence;
  fuseFinal(place);
}

void TraceBook::fuseFinal(std::size_t place) {
  const Evidence& evidence = evidence_[place];
  Verdict& verdict = verdicts_[place];
  verdict.final = fuseTrace(verdict.motion, evidence.all, evidence.whileFast, options_);
}

MotionClass TraceBook::liveClass(TrackId track) const {
  const Verdict* verdict = find(track);
  return verdict == nullptr ? MotionClass::Static : verdict->live;
}

MotionClass TraceBook::finalClass(TrackId track, bool last) const {
  constexpr int kScansForVerdict = 5;
  const Verdict* verdict = find(track);
  if (verdict == nullptr) return MotionClass::Static;
  if (awaitEvidence_ && !last && verdict->scansWithEvidence < kScansForVerdict)
    return MotionClass::Static;
  return verdict->final;
}

bool TraceBook::mayMove(TrackId track, bool last) const {
  const Verdict* verdict = find(track);
  const bool awaited = !last && verdict != nullptr && verdict->motion != MotionClass::Static;
  return awaited || isDynamic(finalClass(track, last));
}

bool TraceBook::mayClaim(TrackId track, bool last) const {
  const Verdict* verdict = find(track);
  return verdict != nullptr && mayMove(track, last) &&
         isWellKnown(verdict->sightings, evidence_[static_cast<std::size_t>(track - first_)].all,
                     options_);
}

void TraceBook::forgetBelow(TrackId track) {
  while (!verdicts_.empty() && first_ < track) {
    evidence_.pop_front(), verdicts_.pop_front();
    ++first_;
  }
}

}  // namespace toss
