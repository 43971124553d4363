// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "Scoreboard.h"

namespace toss {

/// Writes results_scenes.png (F1 of each scene by method) and results_ablation.png (change of F1 by
/// variant) into `folder`. Throws UserError where a file can not be written.
void drawPlots(const std::vector<CaseResult>& results, const std::vector<Variant>& variants,
               const std::filesystem::path& folder);

}  // namespace toss
