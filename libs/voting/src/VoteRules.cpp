// SPDX-License-Identifier: BSD-3-Clause
#include "VoteRules.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {

VoteRules::VoteRules(const VotingOptions& options) : options_(options) {
  options_.checkAll();
  horizon_ = options_.horizon > 0.0 ? options_.horizon + kTimeTolerance
                                    : std::numeric_limits<double>::infinity();
}

double VoteRules::tau(double extent) const {
  if (options_.mode == VotingMode::Literal) return options_.tau;
  return std::clamp(options_.tauScale * extent, options_.tauMin, options_.tauMax);
}

double VoteRules::reach() const {
  const double largest = options_.mode == VotingMode::Literal ? options_.tau : options_.tauMax;
  // Voter::tau is a float: it may be above the double it was made from.
  return (options_.tauDriftPerSecond > 0.0 ? 2.0 : 1.0) * largest * (1.0 + 1e-6);
}

double VoteRules::reach(const Voter& voted) const {
  return (options_.tauDriftPerSecond > 0.0 ? 2.0 : 1.0) * static_cast<double>(voted.tau);
}

Voter VoteRules::voter(const VotingBox& box, BoxId id, std::uint32_t trace,
                       std::int32_t scan) const {
  Voter voter;
  voter.center = box.center;
  voter.time = box.time;
  voter.tau = static_cast<float>(tau(box.extent));
  voter.volume = static_cast<float>(box.volume);
  voter.speed = static_cast<float>(box.speed);
  voter.scan = scan;
  voter.id = id;
  voter.trace = trace;
  return voter;
}

bool VoteRules::isNear(const Voter& voted, const Voter& voter) const {
  double radius = voted.tau;
  if (options_.tauDriftPerSecond > 0.0) {
    const double growth = options_.tauDriftPerSecond * std::abs(voter.time - voted.time);
    radius += std::min(growth, radius);
  }
  return (voter.center - voted.center).squaredNorm() < radius * radius;
}

bool VoteRules::canVoteDynamic(MotionClass voterClass) const {
  return options_.mode == VotingMode::Literal || toss::isDynamic(voterClass);
}

bool VoteRules::canVoteStatic(MotionClass voterClass) const {
  switch (options_.mode) {
    case VotingMode::Off:
      return false;
    case VotingMode::Literal:
      return true;
    case VotingMode::DynamicOnly:
      return toss::isDynamic(voterClass);
    case VotingMode::Classwise:
      return !toss::isDynamic(voterClass);
    case VotingMode::Guarded:
      return voterClass != MotionClass::Strong;
  }
  return false;
}

bool VoteRules::votesDynamic(const Voter& voted, const Voter& voter, MotionClass voterClass) const {
  if (voter.trace == Voter::kNoTrace || !canVoteDynamic(voterClass)) return false;
  if (options_.mode == VotingMode::Guarded && voter.trace != voted.trace) {
    if (voter.speed < options_.movingSpeed) return false;
    if (!sizesMatch(voted, voter, options_.dynamicSizeCompatibility)) return false;
  }
  return isNear(voted, voter);
}

bool VoteRules::votesStatic(const Voter& voted, const Voter& voter, MotionClass voterClass) const {
  if (voter.trace == Voter::kNoTrace || !canVoteStatic(voterClass)) return false;
  if (options_.mode == VotingMode::Guarded) {
    const bool own = voter.trace == voted.trace;
    if (toss::isDynamic(voterClass) && (own || !(voter.speed < options_.slowSpeed))) return false;
    if (!own && !sizesMatch(voted, voter, options_.sizeCompatibility)) return false;
  }
  return isNear(voted, voter);
}

bool VoteRules::vetoes(MotionClass own) const {
  return options_.mode == VotingMode::Guarded && own == MotionClass::Strong;
}

bool VoteRules::emptyVoteIsCoarse() const {
  if (options_.emptyVote != EmptyVote::ByMode) return options_.emptyVote == EmptyVote::Coarse;
  return options_.mode == VotingMode::DynamicOnly || options_.mode == VotingMode::Guarded;
}

bool VoteRules::staticWithoutDynamicVotes(MotionClass own) const {
  return !toss::isDynamic(own) && emptyVoteIsCoarse();
}

bool VoteRules::isDynamic(const DsVoting::Votes& votes, MotionClass own) const {
  if (off()) return toss::isDynamic(own);
  if (vetoes(own)) return true;
  if (votes.dynamic == 0 && votes.stationary == 0 && emptyVoteIsCoarse()) {
    return toss::isDynamic(own);
  }
  return votes.dynamic >= votes.stationary;
}

bool VoteRules::sizesMatch(const Voter& a, const Voter& b, double ratio) const {
  return std::min(a.volume, b.volume) >= ratio * std::max(a.volume, b.volume);
}

}  // namespace toss
