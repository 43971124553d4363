// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "AssociationStudy.h"
#include "Scoreboard.h"

namespace toss {

/// Writes results.md into request.output. `pictures`: Markdown for what was drawn, one entry each.
void writeResults(const ScoreboardRequest& request, const std::vector<CaseResult>& results,
                  const std::vector<Variant>& variants, const AssociationStudy& association,
                  const std::vector<std::string>& pictures);

}  // namespace toss
