// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/EvaluationOptions.h>
#include <toss/evaluation/LossCauses.h>
#include <toss/evaluation/MethodRun.h>
#include <toss/evaluation/MovingScores.h>
#include <toss/evaluation/PreservationRejection.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace toss {

/// Scores of a run: those of `toss eval` that a table of many runs has room for.
struct RunScores {
  /// Maps of the final labels, and of the live labels where there are any.
  PreservationRejection map;
  std::optional<PreservationRejection> liveMap;
  /// Points called moving.
  MovingScores moving;
  std::optional<MovingScores> liveMoving;
  /// Where the residue comes from.
  LossTable losses;
  /// What the right class for every instance, and for every trace, would reach (spec section 11).
  std::optional<PreservationRejection> instanceBound, traceBound;
  /// Time per scan [ms].
  double medianMilliseconds = 0.0, percentile95Milliseconds = 0.0;
  /// Median time by stage [ms], in the order of the stages.
  std::vector<std::pair<std::string, double>> stageMedians;
};

/// Scores a run against the true labels of its log. `errors`, if given, receives the voxels of the
/// truth by fate. `options`: from, to and stride have no effect.
RunScores scoreRun(const LabelledLog& log, const MethodRun& run, const EvaluationOptions& options,
                   MapErrors* errors = nullptr);

/// The quantile of `values` at `share`, 0 to 1, by nearest rank; 0 for none.
double quantile(std::vector<double> values, double share);

}  // namespace toss
