// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/EvaluationOptions.h>
#include <toss/evaluation/EvaluationReport.h>

#include <filesystem>
#include <functional>

namespace toss {

struct InputOptions;

/// Share of the evaluation that is done, 0 to 1, ascending.
using EvaluationProgress = std::function<void(double)>;

/// Scores a run against the truth (spec sections 9 and 11).
///
/// `truth`: an input of TOSS with true labels: a KITTI folder with labels/, or a rawlog with
/// <stem>_labels/ beside it. True boxes, if any: tracks.csv in the folder or <stem>_tracks.csv.
/// `runOrMap`: a folder of `toss map`; or a folder of label files in SemanticKITTI's layout, itself
/// or with labels/ or predictions/ in it; or the map of any program (PLY, PCD, .metricmap).
/// `input`: how the truth is read; as in the run.
/// `errors`, if given, receives the voxels of the truth by fate: by the labels where the run has
/// them, else by the map.
/// Throws UserError for paths, files or options that do not fit.
EvaluationReport evaluateRun(const std::filesystem::path& truth,
                             const std::filesystem::path& runOrMap,
                             const EvaluationOptions& options, const InputOptions& input,
                             const EvaluationProgress& progress = {}, MapErrors* errors = nullptr);

}  // namespace toss
