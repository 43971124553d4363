// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/ClassOracle.h>
#include <toss/evaluation/EvaluationOptions.h>

#include <cstdint>
#include <filesystem>

namespace toss {

/// What has to be known of all labels before the first scan is scored; read from the label files
/// alone.
struct LabelSurvey {
  /// Whether true class 0 is left out, by EvaluationOptions::unlabelled.
  bool ignoreUnlabelled = false;
  /// True labels in all, and of them of class 0; labels of the run in all, and of them of class 0.
  std::uint64_t trueLabels = 0, trueUnlabelled = 0, runLabels = 0, runInvalid = 0;
  /// Majority of the true labels of each trace over the whole run.
  ClassOracle traces;
};

/// `runLabels`: "" where the run has none. Throws UserError for label files that do not fit
/// together.
LabelSurvey surveyLabels(const std::filesystem::path& trueLabels,
                         const std::filesystem::path& runLabels, const EvaluationOptions& options);

}  // namespace toss
