// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "BoxRecords.h"
#include "VoteCounter.h"

namespace toss {

/// What DsVoting is made of. What keeps it cheap (spec section 7.4): a static box needs no count of
/// its votes for static, since it stays static until a vote for dynamic comes in or a trace near it
/// turns dynamic, and then it is judged from scratch; a dynamic box has its counts and waits, in
/// its cell, for the votes for static that may turn it. Boxes near traces whose class changes are
/// judged when a label is asked for: mostly several classes change before that.
class OnlineVoting {
 public:
  explicit OnlineVoting(const VotingOptions& options)
      : rules_(options), grid_(rules_.reach()), counter_(rules_, grid_, traces_) {}

  BoxId addScan(const std::vector<VotingBox>& boxes);
  void setTrackClass(TrackId track, MotionClass motion);
  bool isDynamic(BoxId box) {
    judgeDirty();
    return records_.known(box).dynamic;
  }
  DsVoting::Votes votes(BoxId box);
  std::vector<BoxId> takeChanges();
  void release(BoxId box);
  void forgetBefore(double time);

 private:
  static constexpr std::size_t kFewChanges = 1024;

  void startScan(const std::vector<VotingBox>& boxes);
  /// Whether boxes of the trace can vote for dynamic as its class is now.
  bool canVoteDynamic(TraceList::TraceIndex trace) const {
    return trace != Voter::kNoTrace && rules_.canVoteDynamic(traces_.motion(trace));
  }
  /// Votes of a box of the present scan on boxes of earlier ones.
  void voteDynamic(const Voter& voter, MotionClass motion);
  void voteStatic(const Voter& voter, MotionClass motion);
  /// Whether the pending box goes on waiting after the vote of `voter` on it.
  bool voteStatic(const Voter& pending, const Voter& voter, MotionClass motion);
  void markDirty(BoxId box);
  void markAround(const TraceList::CellCount& count);
  void judgeDirty();
  /// Counts the votes and sets the label.
  void judge(const Voter& voted);
  void setLabel(BoxRecord& record, const Voter& voted, bool dynamic);
  void noteChange(BoxId box);
  /// Keeps each box in changed_ once, and none whose changes nobody can ask for any more.
  void tidyChanges();

  VoteRules rules_;
  VoterGrid grid_;
  TraceList traces_;
  BoxRecords records_;
  VoteCounter counter_;
  std::vector<BoxId> dirty_, changed_;
  /// Number of changes that are tidied next: takeChanges() may never be called.
  std::size_t manyChanges_ = kFewChanges;
  std::int32_t scan_ = -1;
  std::int64_t scanNumber_ = 0;
  double time_ = 0.0;
};

}  // namespace toss
