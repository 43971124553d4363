// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/voting/DsVoting.h>

#include "ScanRecord.h"
#include "TraceBook.h"

namespace toss {

/// Says which owners of a scan move, from votes, traces and free space together. Owners of residue
/// move with their trace here: so the map wants it.
class Judge {
 public:
  Judge(const DecisionOptions& options, const DsVoting& voting, const TraceBook& traces)
      : options_(options), voting_(voting), traces_(traces) {}

  /// With no look-ahead, shape [owners]. `evidence`: what past views say, shape [instances + 1].
  std::vector<bool> live(const ScanRecord& record, const std::vector<FreeSpaceSum>& evidence) const;
  /// By all that is known now, shape [owners]. `last`: nothing more will be known.
  std::vector<bool> final(const ScanRecord& record, bool last) const;
  /// Marks the returns that views saw through although no moving owner has them.
  void findLoneMovers(const EvidenceCells& cells, ScanRecord& record) const;

 private:
  DecisionOptions options_;
  const DsVoting& voting_;
  const TraceBook& traces_;
};

}  // namespace toss
