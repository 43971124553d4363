// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <vector>

namespace toss {

/// The paper's association: each box is compared with the `candidates` nearest traces that have it
/// in reach, O(kN). Chooses the same pairs as the exhaustive method as long as no box has more
/// traces in reach than that (spec section 5.6).
std::vector<AssociationPair> associateHierarchically(const AssociationProblem& problem,
                                                     int candidates, AssignmentMethod assignment);

}  // namespace toss
