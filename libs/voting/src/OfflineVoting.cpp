// SPDX-License-Identifier: BSD-3-Clause
#include <toss/voting/DsVoting.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "VoteRules.h"

namespace toss {

namespace {

/// The boxes as voters, with traces numbered from 1 in order of their coming.
std::vector<Voter> makeVoters(const VoteRules& rules, const std::vector<VotingBox>& boxes) {
  std::map<TrackId, std::uint32_t> numberOf{{0, Voter::kNoTrace}};
  std::vector<Voter> voters;
  for (const VotingBox& box : boxes) {
    const auto number = static_cast<std::uint32_t>(numberOf.size());
    const auto trace = numberOf.try_emplace(box.track, number).first->second;
    voters.push_back(rules.voter(box, voters.size(), trace, 0));
  }
  return voters;
}

}  // namespace

std::vector<bool> voteOffline(const std::vector<VotingBox>& boxes,
                              const std::vector<MotionClass>& classes,
                              const VotingOptions& options) {
  if (classes.size() != boxes.size()) throw std::logic_error("voteOffline: one class per box");
  const VoteRules rules(options);
  const std::vector<Voter> voters = makeVoters(rules, boxes);
  std::vector<bool> result;
  for (std::size_t voted = 0; voted < boxes.size(); ++voted) {
    std::set<std::int64_t> dynamicScans, staticScans;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double gap = std::abs(boxes[i].time - boxes[voted].time);
      if (gap <= rules.adjacent() && rules.votesDynamic(voters[voted], voters[i], classes[i])) {
        dynamicScans.insert(boxes[i].scan);
      }
      if (gap >= rules.distant() && gap <= rules.horizon() &&
          rules.votesStatic(voters[voted], voters[i], classes[i])) {
        staticScans.insert(boxes[i].scan);
      }
    }
    const DsVoting::Votes votes{static_cast<int>(dynamicScans.size()),
                                static_cast<int>(staticScans.size())};
    const bool traced = voters[voted].trace != Voter::kNoTrace;
    result.push_back(rules.isDynamic(votes, traced ? classes[voted] : MotionClass::Static));
  }
  return result;
}

}  // namespace toss
