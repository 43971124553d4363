// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/voting/DecisionOptions.h>

#include "ClaimFinder.h"
#include "TraceBook.h"

namespace toss {

/// What moving traces claim of a scan for its live labels, by what is known when it comes in (spec
/// section 10.2): sparse returns, and what has melted into a standing instance. No map tells yet
/// what else was measured there, so it is no ground, and nothing far beside the box.
class LiveClaims {
 public:
  /// `traces` must outlive this.
  LiveClaims(const DecisionOptions& options, const TraceBook& traces)
      : claiming_(options.claims), traces_(traces), finder_(kMarginShare * options.residueMargin) {}

  /// The claims on a scan, whose coordinates are needed; valid until the next are found. `moving`:
  /// which of its owners move.
  const std::vector<Claim>& find(const ScanRecord& record, const std::vector<bool>& moving);
  /// Makes them moving in the live labels of the scan.
  void add(const ScanRecord& record, const std::vector<bool>& moving, ScanLabels& labels);

 private:
  static constexpr double kMarginShare = 0.5;

  bool claiming_;
  const TraceBook& traces_;
  std::vector<Claimant> claimants_;
  ClaimFinder finder_;
};

}  // namespace toss
