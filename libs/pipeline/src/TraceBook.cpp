// SPDX-License-Identifier: BSD-3-Clause
#include "TraceBook.h"

namespace toss {

TraceBook::Trace& TraceBook::at(TrackId track) {
  while (first_ + traces_.size() <= track) traces_.emplace_back();
  return traces_[static_cast<std::size_t>(track - first_)];
}

const TraceBook::Trace* TraceBook::find(TrackId track) const {
  if (track < first_ || track >= first_ + traces_.size()) return nullptr;
  return &traces_[static_cast<std::size_t>(track - first_)];
}

void TraceBook::addFinal(TrackId track, const FreeSpaceSum& evidence) {
  Trace& trace = at(track);
  trace.all.add(evidence);
  ++trace.scansWithEvidence;
}

MotionClass TraceBook::liveClass(TrackId track) const {
  const Trace* trace = find(track);
  if (trace == nullptr) return MotionClass::Static;
  DecisionOptions live = options_;
  live.traceFreeShare = options_.liveFreeShare;
  return fuseTrace(trace->motion, trace->past, live);
}

MotionClass TraceBook::finalClass(TrackId track, bool last) const {
  constexpr int kScansForVerdict = 5;
  const Trace* trace = find(track);
  if (trace == nullptr) return MotionClass::Static;
  if (awaitEvidence_ && !last && trace->scansWithEvidence < kScansForVerdict)
    return MotionClass::Static;
  return fuseTrace(trace->motion, trace->all, options_);
}

void TraceBook::forgetBelow(TrackId track) {
  while (!traces_.empty() && first_ < track) {
    traces_.pop_front();
    ++first_;
  }
}

}  // namespace toss
