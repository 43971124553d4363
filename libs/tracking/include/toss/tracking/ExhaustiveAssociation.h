// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <vector>

namespace toss {

/// The baseline of the paper: the full matrix of boxes and traces with the same gates, solved as a
/// whole. O(NM) costs; the reference for associateHierarchically().
std::vector<AssociationPair> associateExhaustively(const AssociationProblem& problem,
                                                   AssignmentMethod assignment);

/// Auto-MOS's matrix: each violated gate counts 1e8 instead of its term, all rows are filled, pairs
/// below 1e8 are kept (spec section 5.5). May give up an admissible pair for forbidden ones.
std::vector<AssociationPair> associateLikeAutoMos(const AssociationProblem& problem);

}  // namespace toss
