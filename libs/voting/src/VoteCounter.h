// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "ScanTally.h"
#include "TraceList.h"
#include "VoterGrid.h"

namespace toss {

/// Counts the votes on one box from all boxes that are remembered: N_dyn and N_stat of the paper,
/// with at most one vote of each kind per scan.
class VoteCounter {
 public:
  static constexpr int kNoLimit = std::numeric_limits<int>::max();

  VoteCounter(const VoteRules& rules, VoterGrid& grid, const TraceList& traces)
      : rules_(rules), grid_(grid), traces_(traces) {}

  int countDynamic(const Voter& voted);
  /// Stops as soon as `limit` votes are found.
  int countStatic(const Voter& voted, int limit = kNoLimit);

 private:
  void countStatic(const Voter& voted, const Voter* first, const Voter* last, int limit);

  const VoteRules& rules_;
  VoterGrid& grid_;
  const TraceList& traces_;
  ScanTally tally_;
};

}  // namespace toss
