// SPDX-License-Identifier: BSD-3-Clause
#include "OnlineVoting.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace toss {

namespace {

void checkBox(const VotingBox& box, const VotingBox& first) {
  if (box.scan != first.scan || box.time != first.time) {
    throw std::logic_error("DsVoting: boxes of different scans in one call");
  }
  if (!box.center.allFinite() || !std::isfinite(box.time) || !std::isfinite(box.volume) ||
      !std::isfinite(box.extent) || !std::isfinite(box.speed)) {
    throw std::logic_error("DsVoting: a box that is not finite");
  }
}

}  // namespace

void OnlineVoting::startScan(const std::vector<VotingBox>& boxes) {
  for (const VotingBox& box : boxes) checkBox(box, boxes.front());
  const VotingBox& first = boxes.front();
  if (scan_ >= 0 && (first.scan <= scanNumber_ || !(first.time > time_))) {
    throw std::logic_error("DsVoting: scans must come in order of time");
  }
  ++scan_;
  scanNumber_ = first.scan;
  time_ = first.time;
  records_.startScan(time_);
}

BoxId OnlineVoting::addScan(const std::vector<VotingBox>& boxes) {
  const BoxId firstId = records_.nextId();
  if (boxes.empty()) return firstId;
  startScan(boxes);
  for (const VotingBox& box : boxes) {
    const TraceList::TraceIndex trace = traces_.indexOf(box.track);
    const Voter voter = rules_.voter(box, records_.nextId(), trace, scan_);
    BoxRecord record;
    record.cell = grid_.insert(voter);
    if (canVoteDynamic(trace)) ++grid_.cell(record.cell).dynamicVoters;
    traces_.addBox(trace, record.cell, box.center);
    const BoxId id = records_.add(record);
    markDirty(id);
  }
  for (BoxId id = firstId; id < records_.nextId(); ++id) {
    const Voter& voter = grid_.find(records_[id].cell, id);
    if (rules_.off() || voter.trace == Voter::kNoTrace) continue;
    const MotionClass motion = traces_.motion(voter.trace);
    if (rules_.canVoteDynamic(motion)) voteDynamic(voter, motion);
    if (rules_.canVoteStatic(motion)) voteStatic(voter, motion);
  }
  judgeDirty();
  return firstId;
}

void OnlineVoting::voteDynamic(const Voter& voter, MotionClass motion) {
  grid_.visit(voter.center, rules_.reach(), [&](const VoterCell& cell) {
    for (const Voter* v = cell.end(); v != cell.begin();) {
      const Voter& voted = *--v;
      if (voter.time - voted.time > rules_.adjacent()) break;
      if (voted.scan == voter.scan || !records_.isOpen(voted.id)) continue;
      BoxRecord& record = records_[voted.id];
      if (record.dirty || record.lastDynamicScan == scan_) continue;
      if (!rules_.votesDynamic(voted, voter, motion)) continue;
      if (record.dynamic) {
        ++record.votes.dynamic;
        record.lastDynamicScan = scan_;
      } else {
        markDirty(voted.id);
      }
    }
  });
}

void OnlineVoting::voteStatic(const Voter& voter, MotionClass motion) {
  grid_.visit(voter.center, rules_.reach(), [&](VoterCell& cell) {
    std::vector<Voter>& pending = cell.pending;
    for (std::size_t i = 0; i < pending.size();) {
      if (voteStatic(pending[i], voter, motion)) {
        ++i;
        continue;
      }
      if (records_.has(pending[i].id)) records_[pending[i].id].pending = false;
      pending[i] = pending.back();
      pending.pop_back();
    }
  });
}

bool OnlineVoting::voteStatic(const Voter& pending, const Voter& voter, MotionClass motion) {
  const double wait = voter.time - pending.time;
  if (!records_.isOpen(pending.id) || wait > rules_.horizon()) return false;
  BoxRecord& record = records_[pending.id];
  if (!record.dynamic) return false;
  if (wait < rules_.distant() || record.lastStaticScan == scan_) return true;
  if (!rules_.votesStatic(pending, voter, motion)) return true;
  ++record.votes.stationary;
  record.lastStaticScan = scan_;
  if (rules_.isDynamic(record.votes, traces_.motion(pending.trace))) return true;
  // A vote for dynamic from this very scan may still outweigh it: judged when all are in.
  markDirty(pending.id);
  return true;
}

void OnlineVoting::markDirty(BoxId box) {
  BoxRecord& record = records_[box];
  if (record.dirty) return;
  record.dirty = true;
  dirty_.push_back(box);
}

void OnlineVoting::judgeDirty() {
  for (const BoxId id : dirty_) {
    records_[id].dirty = false;
    judge(grid_.find(records_[id].cell, id));
  }
  dirty_.clear();
}

void OnlineVoting::judge(const Voter& voted) {
  BoxRecord& record = records_[voted.id];
  const MotionClass own = traces_.motion(voted.trace);
  record.lastDynamicScan = record.lastStaticScan = scan_;
  record.votes = {};
  if (!rules_.off() && !rules_.vetoes(own)) {
    record.votes.dynamic = counter_.countDynamic(voted);
    if (record.votes.dynamic > 0 || !rules_.staticWithoutDynamicVotes(own)) {
      record.votes.stationary = counter_.countStatic(voted, record.votes.dynamic + 1);
    }
  }
  setLabel(record, voted, rules_.isDynamic(record.votes, own));
}

void OnlineVoting::setLabel(BoxRecord& record, const Voter& voted, bool dynamic) {
  if (record.dynamic != dynamic) noteChange(voted.id);
  record.dynamic = dynamic;
  const bool final = rules_.off() || rules_.vetoes(traces_.motion(voted.trace));
  if (!dynamic || final || record.pending) return;
  record.pending = true;
  grid_.cell(record.cell).pending.push_back(voted);
}

void OnlineVoting::setTrackClass(TrackId track, MotionClass motion) {
  if (track == 0) throw std::logic_error("DsVoting: track 0 has no class");
  const TraceList::TraceIndex known = traces_.find(track);
  if (motion == (known == Voter::kNoTrace ? MotionClass::Static : traces_.motion(known))) return;
  const bool couldVote = known != Voter::kNoTrace && canVoteDynamic(known);
  const TraceList::TraceIndex trace = traces_.setMotion(track, motion, time_);
  const int votersPerBox = (canVoteDynamic(trace) ? 1 : 0) - (couldVote ? 1 : 0);
  for (const TraceList::CellCount& count : traces_.cells(trace)) {
    grid_.cell(count.cell).dynamicVoters += votersPerBox * count.boxes;
    markAround(count);
  }
}

/// Marks the boxes that those of a trace in a cell may vote on, themselves among them.
void OnlineVoting::markAround(const TraceList::CellCount& count) {
  grid_.visitAround(count.cell, [&](const VoterCell& cell) {
    for (const Voter& voter : cell) {
      const double reach = rules_.reach(voter);
      const bool near = count.centers.squaredExteriorDistance(voter.center) <= reach * reach;
      if (near && records_.isOpen(voter.id)) markDirty(voter.id);
    }
  });
}

DsVoting::Votes OnlineVoting::votes(BoxId box) {
  judgeDirty();
  const BoxRecord& record = records_.known(box);
  if (rules_.off() || !records_.isOpen(box)) return record.votes;
  const Voter& voted = grid_.find(record.cell, box);
  return {counter_.countDynamic(voted), counter_.countStatic(voted)};
}

void OnlineVoting::noteChange(BoxId box) {
  changed_.push_back(box);
  if (changed_.size() < manyChanges_) return;
  tidyChanges();
  manyChanges_ = std::max(kFewChanges, 2 * changed_.size());
}

void OnlineVoting::tidyChanges() {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  const auto isOver = [this](BoxId box) { return !records_.has(box) || records_[box].released; };
  changed_.erase(std::remove_if(changed_.begin(), changed_.end(), isOver), changed_.end());
}

std::vector<BoxId> OnlineVoting::takeChanges() {
  judgeDirty();
  tidyChanges();
  const auto isNews = [this](BoxId box) { return records_[box].dynamic != records_[box].reported; };
  std::vector<BoxId> result;
  std::copy_if(changed_.begin(), changed_.end(), std::back_inserter(result), isNews);
  for (const BoxId box : result) records_[box].reported = records_[box].dynamic;
  changed_.clear();
  return result;
}

void OnlineVoting::release(BoxId box) {
  judgeDirty();
  records_.known(box);
  records_[box].released = true;
}

void OnlineVoting::forgetBefore(double time) {
  judgeDirty();
  const double horizon = std::isinf(rules_.horizon()) ? 0.0 : rules_.horizon();
  records_.closeBefore(time);
  records_.removeVotersBefore(time - horizon, [this](BoxId box) {
    const VoterGrid::CellIndex cell = records_[box].cell;
    const TraceList::TraceIndex trace = grid_.cell(cell).begin()->trace;
    if (canVoteDynamic(trace)) --grid_.cell(cell).dynamicVoters;
    traces_.removeBox(trace, cell);
    grid_.removeEarliest(cell);
  });
  traces_.forgetUnused(time - horizon);
}

}  // namespace toss
