// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/MappingOptions.h>
#include <toss/voting/DecisionOptions.h>

#include <deque>

#include "ClaimFinder.h"
#include "ClaimingOwners.h"
#include "TraceBook.h"

namespace toss {

/// What moving traces claim of a scan when it enters the map, some seconds later, by what has
/// become known of them by then (spec sections 10.2 and 10.3): feet and tyres in the ground layer,
/// returns too sparse for an instance, what has melted into a standing instance; and in the scans
/// before a trace was first seen what lies on its way, as who comes out from behind a bush was
/// there before. All of it is residue: this scan alone can not tell it from what stands there.
class HindsightClaims {
 public:
  /// Without voxels no map tells whether anything else was measured in a place: then no ground is
  /// claimed. `traces` must outlive this.
  HindsightClaims(const DecisionOptions& options, const MappingOptions& mapping,
                  const TraceBook& traces);

  /// Adds the claims on records[index], which has none yet and whose coordinates are needed.
  /// `last`: as for TraceBook::finalClass. `moving`: which of the scan's owners move, to which the
  /// new ones are added.
  void add(std::deque<ScanRecord>& records, std::size_t index, bool last,
           std::vector<bool>& moving);

 private:
  using Records = std::deque<ScanRecord>;

  /// The boxes of moving traces in records[index], and where those of later scans were then.
  void findClaimants(const Records& records, std::size_t index, bool last);
  /// Follows the traces that began in records[birth] back to the time [s] of an earlier scan.
  void followBack(const Records& records, std::size_t birth, double time, bool last);
  void addClaim(const Claim& claim, ScanRecord& record);

  bool claiming_, claimingGround_;
  double birthTime_;
  const TraceBook& traces_;
  std::vector<Claimant> claimants_;
  ClaimFinder finder_;
  ClaimingOwners owners_;
};

}  // namespace toss
