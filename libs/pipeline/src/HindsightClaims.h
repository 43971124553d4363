// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/MappingOptions.h>
#include <toss/voting/DecisionOptions.h>

#include <deque>

#include "BoxClaims.h"
#include "ClaimingOwners.h"
#include "ScanRecord.h"
#include "TraceBook.h"

namespace toss {

/// What moving traces claim of a scan when it enters the map, some seconds later, by what has
/// become known of them since (spec sections 10.2 and 10.3): in the scans before a trace was first
/// seen, what lies on its way, as who comes out from behind a bush was there before in too few
/// returns or merged with the bush; and what its box takes in scans in which it was not known to
/// move. All of it is residue, and none of it ground.
class HindsightClaims {
 public:
  /// `traces` must outlive this.
  HindsightClaims(const DecisionOptions& options, const MappingOptions& mapping,
                  const TraceBook& traces);

  /// Adds the claims on records[index], whose coordinates are needed. `last`: as for
  /// TraceBook::finalClass. `moving`: which of the scan's owners move, to which the new ones are
  /// added.
  void add(std::deque<ScanRecord>& records, std::size_t index, bool last,
           std::vector<bool>& moving);

 private:
  using Records = std::deque<ScanRecord>;

  /// The boxes of moving traces in records[index], and where those of later scans were then.
  void findClaimants(const Records& records, std::size_t index, bool last);
  /// Follows the traces that began in records[birth] back to the time [s] of an earlier scan.
  void followBack(const Records& records, std::size_t birth, double time, bool last);
  void addClaimant(TrackId track, const Box& box);
  void claimReturns(const std::vector<bool>& moving, ScanRecord& record);
  void markSquares(const Eigen::Vector3d& sensorPosition);
  /// Calls `visit(point)` for the returns of objects that lie in marked squares.
  template <typename Visit>
  void visitNearby(const ScanRecord& record, Visit&& visit) const;
  void claim(std::size_t point, std::int32_t claimant, ScanRecord& record);

  bool claiming_;
  double birthTime_;
  float margin_;
  const TraceBook& traces_;
  /// Of the scan at hand: its claimants, their traces, and what they have claimed.
  std::vector<BoxClaims::Claimant> claimants_;
  std::vector<TrackId> trackOf_;
  std::vector<std::int32_t> claimed_;
  BoxClaims boxes_;
  ClaimingOwners owners_;
  /// Whether a box reaches into each square of a ClaimGrid.
  std::vector<std::uint8_t> marks_;
};

}  // namespace toss
