// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <vector>

namespace toss {

/// Chooses among admissible pairs so that each box and each trace has at most one (spec section
/// 5.6); result by ascending detection. Optimal: exactly, component by component of the graph that
/// the pairs form. `detectionCount`, `targetCount`: sizes of the problem.
std::vector<AssociationPair> resolveConflicts(std::vector<AssociationPair> pairs,
                                              AssignmentMethod method, std::size_t detectionCount,
                                              std::size_t targetCount);

}  // namespace toss
