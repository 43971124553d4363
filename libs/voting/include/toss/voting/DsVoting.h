// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Track.h>
#include <toss/voting/VotingOptions.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace toss {

/// Identity of a box that is voted on: counted from 0 in the order of DsVoting::add.
using BoxId = std::uint64_t;

/// A box of one scan, as a voter and as what is voted on.
struct VotingBox {
  /// Number of the scan; boxes of one scan share it and give at most one vote together.
  std::int64_t scan = 0;
  /// Time of the scan [s].
  double time = 0.0;
  /// Centre of the box [m], map frame.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /// Volume of the box [m^3] and longer horizontal edge [m].
  double volume = 0.0, extent = 0.0;
  /// Horizontal speed of its trace [m/s]; 0 without a trace.
  double speed = 0.0;
  /// Trace of the box, 0 = none: then it votes for nothing, and is voted on as static.
  TrackId track = 0;
};

/// DS-Voting (paper section DS-Voting, f, N_dyn, N_stat; spec section 7): decides for every box
/// whether it is static or dynamic from the traces that come near its centre at neighbouring times
/// and at distant ones. Works scan by scan and revises its labels as votes come in and as traces
/// turn dynamic; with an infinite horizon the labels equal voteOffline() exactly. For one thread at
/// a time, the const functions too: they judge what has changed since they were called last.
class DsVoting {
 public:
  /// Throws UserError for options out of range.
  explicit DsVoting(const VotingOptions& options);
  ~DsVoting();

  /// Takes all boxes of one scan together (a later scan than the last call's), with the present
  /// class of their traces already set by setTrackClass. Returns the id of the first; the others
  /// follow in order. Throws std::logic_error for scans out of order and boxes not finite.
  BoxId addScan(const std::vector<VotingBox>& boxes);
  /// The coarse class of a trace. Unknown traces are Static. May be raised at any time, for the
  /// whole life of the trace: all its boxes are judged and vote anew (back-propagation).
  void setTrackClass(TrackId track, MotionClass motion);

  /// Label after all votes so far. The box must not be released.
  bool isDynamic(BoxId box) const;
  /// Votes so far {N_dyn, N_stat}, for inspection.
  struct Votes {
    int dynamic = 0, stationary = 0;
  };
  Votes votes(BoxId box) const;

  /// Boxes whose label changed since the last call, ascending, each once. A new box counts as
  /// static before its scan is added; released boxes are not reported.
  std::vector<BoxId> takeChanges();

  /// Forgets what is needed only to judge `box`; it goes on voting. For boxes whose label the
  /// caller has settled: bounds the memory of long runs.
  void release(BoxId box);
  /// Settles the boxes of scans before `time` [s]: their labels stand, whatever comes. Forgets the
  /// voters that no other box needs, those before `time` - horizon, so that the labels of later
  /// boxes do not depend on this call. With an infinite horizon the voters before `time` go all the
  /// same: later boxes that are judged anew have lost their votes. The record of a box goes when it
  /// is forgotten as a voter and released.
  void forgetBefore(double time);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The same decision with the whole log at hand, straight from the definition: the label of each of
/// `boxes` (any order) given the final class of the traces, `classes[i]` of boxes[i]. Quadratic;
/// the reference for DsVoting.
std::vector<bool> voteOffline(const std::vector<VotingBox>& boxes,
                              const std::vector<MotionClass>& classes,
                              const VotingOptions& options);

}  // namespace toss
