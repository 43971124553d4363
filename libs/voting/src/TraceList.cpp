// SPDX-License-Identifier: BSD-3-Clause
#include "TraceList.h"

#include <algorithm>

namespace toss {

TraceList::TraceIndex TraceList::find(TrackId track) const {
  const auto found = indexOf_.find(track);
  return found == indexOf_.end() ? Voter::kNoTrace : found->second;
}

TraceList::TraceIndex TraceList::setMotion(TrackId track, MotionClass motion, double time) {
  TraceIndex trace = find(track);
  if (trace == Voter::kNoTrace) {
    trace = indexOf(track);
    named_.push_back({time, track});
  }
  traces_[trace].motion = motion;
  return trace;
}

TraceList::TraceIndex TraceList::indexOf(TrackId track) {
  if (track == 0) return Voter::kNoTrace;
  const auto [place, isNew] = indexOf_.try_emplace(track, 0u);
  if (isNew) {
    if (free_.empty()) {
      free_.push_back(static_cast<TraceIndex>(traces_.size()));
      traces_.emplace_back();
    }
    place.value() = free_.back();
    free_.pop_back();
    traces_[place->second].id = track;
  }
  return place->second;
}

void TraceList::addBox(TraceIndex trace, VoterGrid::CellIndex cell, const Eigen::Vector3d& center) {
  if (trace == Voter::kNoTrace) return;
  std::vector<CellCount>& cells = traces_[trace].cells;
  const auto found = std::find_if(cells.rbegin(), cells.rend(),
                                  [cell](const CellCount& c) { return c.cell == cell; });
  if (found == cells.rend()) {
    cells.push_back({cell, 1, Eigen::AlignedBox3d(center)});
  } else {
    ++found->boxes;
    found->centers.extend(center);
  }
}

void TraceList::removeBox(TraceIndex trace, VoterGrid::CellIndex cell) {
  if (trace == Voter::kNoTrace) return;
  std::vector<CellCount>& cells = traces_[trace].cells;
  const auto found = std::find_if(cells.begin(), cells.end(),
                                  [cell](const CellCount& c) { return c.cell == cell; });
  if (--found->boxes == 0) cells.erase(found);
  if (cells.empty()) giveUp(trace);
}

void TraceList::forgetUnused(double time) {
  const auto forget = [this, time](const Naming& naming) {
    const TraceIndex trace = find(naming.track);
    if (trace == Voter::kNoTrace) return true;
    if (naming.time >= time) return false;
    if (traces_[trace].cells.empty()) giveUp(trace);
    return true;
  };
  named_.erase(std::remove_if(named_.begin(), named_.end(), forget), named_.end());
}

void TraceList::giveUp(TraceIndex trace) {
  indexOf_.erase(traces_[trace].id);
  traces_[trace] = Trace();
  free_.push_back(trace);
}

}  // namespace toss
