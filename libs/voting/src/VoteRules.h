// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/voting/DsVoting.h>

namespace toss {

/// A box as the vote sees it; the same numbers online and offline, so that both decide alike.
struct Voter {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double time = 0.0;
  /// Radius within which it is voted on: tau [m].
  float tau = 0.0f;
  float volume = 0.0f, speed = 0.0f;
  /// Number of the scan, counted from the first one.
  std::int32_t scan = 0;
  BoxId id = 0;
  /// Place of the trace in the caller's list of traces; kNoTrace = none.
  std::uint32_t trace = 0;

  static constexpr std::uint32_t kNoTrace = 0;
};

/// Whether and how one box votes on another (spec section 7.3), and what the votes come to.
class VoteRules {
 public:
  /// Time stamps are compared with this tolerance [s]: 0.1 s scans make windows of whole scans.
  static constexpr double kTimeTolerance = 1e-3;

  /// Throws UserError for options out of range.
  explicit VoteRules(const VotingOptions& options);

  bool off() const { return options_.mode == VotingMode::Off; }
  /// tau of a box with that longer edge [m].
  double tau(double extent) const;
  /// Largest distance at which any box votes on any other [m].
  double reach() const;
  /// Largest distance at which a box votes on this one [m].
  double reach(const Voter& voted) const;
  /// The box as a voter. `trace`, `scan`: see Voter.
  Voter voter(const VotingBox& box, BoxId id, std::uint32_t trace, std::int32_t scan) const;
  /// Ends of the windows with their tolerance [s]: |dt| <= adjacent() and
  /// distant() <= |dt| <= horizon().
  double adjacent() const { return options_.tauD + kTimeTolerance; }
  double distant() const { return options_.tauS - kTimeTolerance; }
  double horizon() const { return horizon_; }

  /// f of the paper: whether the centres are nearer to each other than tau of the voted box.
  bool isNear(const Voter& voted, const Voter& voter) const;
  /// Whether boxes of a trace of that class can ever vote for dynamic, or for static.
  bool canVoteDynamic(MotionClass voterClass) const;
  bool canVoteStatic(MotionClass voterClass) const;
  /// Whether a voter in the adjacent window votes for dynamic, distance included.
  bool votesDynamic(const Voter& voted, const Voter& voter, MotionClass voterClass) const;
  /// Whether a voter in the distant window votes for static, distance included.
  bool votesStatic(const Voter& voted, const Voter& voter, MotionClass voterClass) const;

  /// Whether a box of a trace of that class is dynamic whatever the votes say (strong veto).
  bool vetoes(MotionClass own) const;
  /// Whether a box that no adjacent voter votes on is static whatever the distant ones say.
  bool staticWithoutDynamicVotes(MotionClass own) const;
  /// The verdict: the paper's N_dyn >= N_stat, with the mode's rule for 0 = 0.
  bool isDynamic(const DsVoting::Votes& votes, MotionClass own) const;

 private:
  bool sizesMatch(const Voter& a, const Voter& b, double ratio) const;
  bool emptyVoteIsCoarse() const;

  VotingOptions options_;
  double horizon_;
};

}  // namespace toss
