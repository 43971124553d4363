// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MapEstimates.h>
#include <toss/evaluation/RunScores.h>
#include <toss/rawlog/LabelFile.h>

#include <algorithm>

#include "LabelSurvey.h"
#include "LabelledScans.h"
#include "ScanGeometry.h"
#include "ScanMembership.h"

namespace toss {
namespace {

LabelSurvey surveyOf(const LabelledLog& log, const MethodRun& run,
                     const EvaluationOptions& options) {
  LabelSurvey survey;
  for (const auto& labels : log.labels) {
    survey.trueLabels += labels.size();
    for (const std::uint32_t value : labels) survey.trueUnlabelled += label::semantic(value) == 0;
  }
  survey.ignoreUnlabelled =
      options.unlabelled == Unlabelled::Ignore ||
      (options.unlabelled == Unlabelled::Auto && 2 * survey.trueUnlabelled > survey.trueLabels);
  for (std::size_t s = 0; s < log.scans.size(); ++s)
    survey.traces.add(log.labels[s], run.answers[s].final, survey.ignoreUnlabelled);
  return survey;
}

std::vector<std::uint32_t> liveLabelsOf(const ScanAnswer& answer) {
  std::vector<std::uint32_t> labels(answer.liveMoving.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = label::semantic(answer.final[i]) == label::kInvalid ? label::kInvalid
                : answer.liveMoving[i]                              ? label::kMoving
                                                                    : label::kStatic;
  return labels;
}

/// Gathers the maps of a run scan by scan and compares them with the truth.
class Scorer {
 public:
  Scorer(const LabelledLog& log, const MethodRun& run, const EvaluationOptions& options)
      : log_(log),
        run_(run),
        options_(options),
        survey_(surveyOf(log, run, options)),
        membership_(options_, survey_),
        estimates_(options.voxelSize, kScoredMaps) {}

  RunScores score(MapErrors* errors) {
    origin_ = evaluationOrigin(log_.scans.front().mapFromSensor.translation(), options_.voxelSize);
    if (!run_.answers.front().liveMoving.empty()) scores_.liveMoving.emplace();
    for (std::size_t s = 0; s < log_.scans.size(); ++s) addScan(s);
    truth_ = estimates_.voxelized(kTruthMap);
    compareRun(errors);
    if (scores_.liveMoving) scores_.liveMap = compare(kLiveMap);
    if (options_.bounds && !run_.answers.front().instances.empty()) {
      scores_.instanceBound = compare(kInstanceOracleMap);
      scores_.traceBound = compare(kTraceOracleMap);
    }
    scores_.medianMilliseconds = quantile(run_.milliseconds, 0.5);
    scores_.percentile95Milliseconds = quantile(run_.milliseconds, 0.95);
    for (const auto& [stage, times] : run_.stages)
      scores_.stageMedians.emplace_back(stage, quantile(times, 0.5));
    return std::move(scores_);
  }

 private:
  void addScan(std::size_t s) {
    const ScanAnswer& answer = run_.answers[s];
    labels_ = {log_.labels[s], answer.final, liveLabelsOf(answer), answer.instances};
    applyClassOptions(options_, labels_.truth);
    transformScan(log_.scans[s], origin_, geometry_);
    membership_.compute(geometry_, labels_);
    orderByCell(geometry_.cloud, options_.voxelSize, order_);
    estimates_.addScan(order_, membership_.facts(), membership_.membership());
    scores_.moving.addScan(labels_.truth, labels_.run, geometry_.range);
    if (scores_.liveMoving)
      scores_.liveMoving->addScan(labels_.truth, labels_.live, geometry_.range);
  }

  void compareRun(MapErrors* errors) {
    const LabelledCloud map = estimates_.voxelized(kRunMap);
    const MapComparison comparison = compareMaps(truth_, map, options_.voxelSize);
    scores_.map = comparison.score;
    scores_.losses = lossTable(truth_, map, comparison);
    if (errors) *errors = mapErrors(truth_, comparison, origin_);
  }

  PreservationRejection compare(ScoredMap map) {
    return compareMaps(truth_, estimates_.voxelized(map), options_.voxelSize).score;
  }

  const LabelledLog& log_;
  const MethodRun& run_;
  const EvaluationOptions& options_;
  LabelSurvey survey_;
  ScanMembership membership_;
  MapEstimates estimates_;
  ScanGeometry geometry_;
  ScanLabelSets labels_;
  CellOrder order_;
  LabelledCloud truth_;
  Eigen::Vector3d origin_;
  RunScores scores_;
};

}  // namespace

RunScores scoreRun(const LabelledLog& log, const MethodRun& run, const EvaluationOptions& options,
                   MapErrors* errors) {
  options.check();
  return Scorer(log, run, options).score(errors);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace toss
