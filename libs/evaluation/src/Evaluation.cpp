// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/Evaluation.h>
#include <toss/geometry/Error.h>

#include "LabelledScans.h"
#include "RunNotes.h"
#include "RunScorer.h"

namespace toss {
namespace {

/// Shares of the whole that the passes take.
constexpr double kSurveyEnd = 0.05, kFirstPassEnd = 0.65, kSecondPassEnd = 0.75;

void check(const EvaluationOptions& options) {
  options.check();
  if (options.removalDistance > options.voxelSize) {
    throw UserError("evaluation.removal_distance", "is greater than evaluation.voxel_size",
                    "choose a smaller one");
  }
}

/// Calls `visit` with every scored scan and reports progress between `begin` and `end`.
template <typename Visit>
void forEachScan(LabelledScans& scans, double begin, double end, const EvaluationProgress& progress,
                 Visit&& visit) {
  PosedScan scan;
  std::vector<std::uint32_t> labels;
  while (scans.next(scan, labels)) {
    visit(scan, labels);
    if (progress) progress(begin + (end - begin) * scans.progress());
  }
}

void addWarnings(const LabelSurvey& survey, EvaluationReport& report) {
  if (report.scansWithoutTruth > 0) {
    report.warnings.push_back(std::to_string(report.scansWithoutTruth) +
                              " scans have no true labels and were left out.");
  }
  if (report.scansWithoutLabels > 0) {
    report.warnings.push_back(std::to_string(report.scansWithoutLabels) +
                              " scans have no labels in the run and were left out.");
  }
  if (2 * survey.runInvalid > survey.runLabels) {
    report.warnings.push_back(
        "More than half of the run's labels are 0, which means no valid return; static is 9.");
  }
  if (2 * report.mapPointsWithoutReturn > report.mapPoints) {
    report.warnings.push_back(
        "Most points of the map are not near any return: is it in the frame of the truth's poses?");
  }
}

void requireScans(const RunScorer& scorer, const std::filesystem::path& truth) {
  if (scorer.scans() > 0) return;
  throw UserError(truth.string(), "no scan of it can be scored",
                  "check evaluation.from, to and stride, and that truth and run belong together");
}

}  // namespace

EvaluationReport evaluateRun(const std::filesystem::path& truth,
                             const std::filesystem::path& runOrMap,
                             const EvaluationOptions& options, const InputOptions& input,
                             const EvaluationProgress& progress, MapErrors* errors) {
  check(options);
  const RunFiles files = findRunFiles(runOrMap);
  LabelledScans first(truth, files.labels, options, input);
  const LabelSurvey survey = surveyLabels(labelsFolderOf(truth), files.labels, options);
  if (progress) progress(kSurveyEnd);

  EvaluationReport report;
  report.truth = truth.string(), report.run = runOrMap.string();
  report.unlabelledIgnored = survey.ignoreUnlabelled, report.voxelSize = options.voxelSize;
  RunScorer scorer(files, survey, options);
  forEachScan(first, kSurveyEnd, kFirstPassEnd, progress,
              [&](const auto& scan, const auto& labels) { scorer.addScan(scan, labels); });
  requireScans(scorer, truth);
  if (scorer.needsSecondPass()) {
    scorer.beginSecondPass();
    LabelledScans second(truth, files.labels, options, input);
    forEachScan(second, kFirstPassEnd, kSecondPassEnd, progress,
                [&](const auto& scan, const auto& labels) { scorer.addScanAgain(scan, labels); });
  }
  scorer.report(trueTracksOf(truth), report, errors);
  report.scansWithoutTruth = first.withoutTruth();
  report.scansWithoutLabels = first.withoutRunLabels();
  if (!files.timings.empty()) report.stages = readStageTimes(files.timings);
  if (!files.summary.empty()) readSummary(files.summary, report);
  if (!files.resources.empty()) readResources(files.resources, report);
  addWarnings(survey, report);
  if (progress) progress(1.0);
  return report;
}

}  // namespace toss
