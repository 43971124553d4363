// SPDX-License-Identifier: BSD-3-Clause
#include "TraceBook.h"

namespace toss {

TraceBook::Trace& TraceBook::at(TrackId track) {
  while (first_ + traces_.size() <= track) traces_.push_back(unknown_);
  return traces_[static_cast<std::size_t>(track - first_)];
}

const TraceBook::Trace* TraceBook::find(TrackId track) const {
  if (track < first_ || track >= first_ + traces_.size()) return nullptr;
  return &traces_[static_cast<std::size_t>(track - first_)];
}

void TraceBook::setMotion(TrackId track, MotionClass motion) {
  Trace& trace = at(track);
  if (trace.motion == motion) return;
  trace.motion = motion;
  trace.live = fuseTrace(motion, trace.past, liveOptions_);
  trace.final = fuseTrace(motion, trace.all, options_);
}

void TraceBook::addPast(TrackId track, const FreeSpaceSum& evidence) {
  Trace& trace = at(track);
  trace.past.add(evidence);
  trace.live = fuseTrace(trace.motion, trace.past, liveOptions_);
}

void TraceBook::addFinal(TrackId track, const FreeSpaceSum& evidence) {
  Trace& trace = at(track);
  trace.all.add(evidence);
  ++trace.scansWithEvidence;
  trace.final = fuseTrace(trace.motion, trace.all, options_);
}

MotionClass TraceBook::liveClass(TrackId track) const {
  const Trace* trace = find(track);
  return trace == nullptr ? MotionClass::Static : trace->live;
}

MotionClass TraceBook::finalClass(TrackId track, bool last) const {
  constexpr int kScansForVerdict = 5;
  const Trace* trace = find(track);
  if (trace == nullptr) return MotionClass::Static;
  if (awaitEvidence_ && !last && trace->scansWithEvidence < kScansForVerdict)
    return MotionClass::Static;
  return trace->final;
}

void TraceBook::forgetBelow(TrackId track) {
  while (!traces_.empty() && first_ < track) {
    traces_.pop_front();
    ++first_;
  }
}

}  // namespace toss
