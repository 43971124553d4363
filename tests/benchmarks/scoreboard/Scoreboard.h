// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/RunScores.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "Variants.h"

namespace toss {

/// What is to be run.
struct ScoreboardRequest {
  bool quick = false;
  /// Most scans of each scene, 40 with `quick`; 0 = the scene's own number. What two cores can do
  /// in an hour with all variants.
  int frames = 100;
  /// The only variants to run, by name; empty = all.
  std::vector<std::string> variants;
  /// Seeds 1 to this; ablations and OctoMap run on seed 1 alone.
  int seeds = 2;
  /// Cases that run at a time.
  int jobs = 2;
  /// Scenes; empty = all, "none" = none.
  std::vector<std::string> scenes;
  /// The real sequence in KITTI layout; empty = none.
  std::filesystem::path realSequence;
  /// Folder for results.md and the pictures; name of the commit.
  std::filesystem::path output;
  std::string commit;
};

/// Scores of one variant on one log, by the log's seed.
struct CaseResult {
  std::string scene, variant;
  std::uint64_t seed = 1;
  std::size_t scans = 0;
  RunScores scores;
};

/// A log, a variant on it, and what came out, for those who draw.
struct FinishedCase {
  const LabelledLog& log;
  const Variant& variant;
  const MethodRun& run;
  const MapErrors& errors;
};

/// Called once per log of seed 1 before its cases run, and after each case of seed 1; one call at a
/// time.
struct ScoreboardObserver {
  std::function<void(const LabelledLog&)> log;
  std::function<void(const FinishedCase&)> finished;
};

/// Runs every variant on every log. Throws UserError for unknown scenes. Results in the order of
/// logs, then of variants.
std::vector<CaseResult> runScoreboard(const ScoreboardRequest& request,
                                      const std::vector<Variant>& variants,
                                      const ScoreboardObserver& observer);

}  // namespace toss
