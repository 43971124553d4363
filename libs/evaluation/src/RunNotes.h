// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/EvaluationReport.h>

#include <filesystem>

namespace toss {

/// Times per stage from a run's timings.csv: one row per scan; each column that is not scan, index
/// or time is a stage [ms], with or without "_ms" at the end of its name. Throws UserError for a
/// file that is no such table.
std::vector<StageTime> readStageTimes(const std::filesystem::path& file);

/// Takes threads, processor and version from a run's summary.json where it names them.
void readSummary(const std::filesystem::path& file, EvaluationReport& report);

/// Takes threads, processor, times and memory from a run's resources.json where it names them.
/// Throws UserError for a file that is no JSON object.
void readResources(const std::filesystem::path& file, EvaluationReport& report);

}  // namespace toss
