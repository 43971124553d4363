// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <vector>

#include "AssociationStudy.h"
#include "Scoreboard.h"

namespace toss {

/// Writes the section "Association time" of results.md: the study's times, and what association
/// costs in the runs of the default and of the variant kExhaustiveName, as far as `results` has
/// both. The plot is expected in association.png.
void writeAssociation(std::ostream& out, const AssociationStudy& study,
                      const std::vector<CaseResult>& results);

}  // namespace toss
