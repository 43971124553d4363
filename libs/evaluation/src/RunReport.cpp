// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/TrackingTruth.h>
#include <toss/evaluation/VoxelGrid.h>
#include <toss/rawlog/LabelFile.h>

#include "RunScorer.h"

namespace toss {
namespace {

TrackingReport trackingReport(const std::vector<TrackingScan>& scans) {
  const TrackConfidence confidence = confidenceByLength(scans);
  return {scoreTracks(scans, confidence), averageAccuracy(scans, confidence)};
}

/// A map without the points of which it is not known what is there.
LabelledCloud withoutUnlabelled(const LabelledCloud& map) {
  LabelledCloud result;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (label::semantic(map.label[i]) != 0) result.add(map.x[i], map.y[i], map.z[i], map.label[i]);
  }
  return result;
}

struct Bound {
  ScoredMap map;
  const char* name;
  bool ofInstances, ofLabels;
};

constexpr Bound kBounds[] = {
    {kInstanceOracleMap, "oracle class per instance", true, true},
    {kBoxOracleMap, "oracle class per trace and scan", false, true},
    {kTraceOracleMap, "oracle class per trace", false, true},
    {kReturns10Map, "perfect labels for objects of 10 returns or more", false, false},
    {kReturns5Map, "perfect labels for objects of 5 returns or more", false, false},
    {kReturns3Map, "perfect labels for objects of 3 returns or more", false, false},
};

}  // namespace

void RunScorer::report(const std::filesystem::path& trueTracks, EvaluationReport& report,
                       MapErrors* errors) {
  report.scans = scans();
  report.points = points_;
  truthMap_ = estimates_.voxelized(kTruthMap);
  if (!files_.labels.empty()) reportLabels(report, errors);
  if (mapTruth_) reportMap(report, files_.labels.empty() ? errors : nullptr);
  if (options_.bounds) reportBounds(report);
  reportTracking(trueTracks, report);
}

MapReport RunScorer::compare(int map, MapErrors* errors) {
  const LabelledCloud estimate = estimates_.voxelized(map);
  const MapComparison comparison = compareMaps(truthMap_, estimate, options_.voxelSize);
  if (errors) *errors = mapErrors(truthMap_, comparison, origin_);
  return {comparison.score, lossTable(truthMap_, estimate, comparison), {}};
}

void RunScorer::reportLabels(EvaluationReport& report, MapErrors* errors) {
  report.labels = compare(kRunMap, errors);
  report.labels->removal = labelRemoval_.result();
  report.moving = moving_;
  if (files_.liveLabels.empty()) return;
  report.liveLabels = compare(kLiveMap, nullptr);
  report.liveMoving = liveMoving_;
}

void RunScorer::reportMap(EvaluationReport& report, MapErrors* errors) {
  LabelledCloud map = mapTruth_->labelled(packFacts(label::kStatic, {}));
  if (survey_.ignoreUnlabelled) map = withoutUnlabelled(map);
  const LabelledCloud estimate = voxelize(map, options_.voxelSize);
  const MapComparison comparison = compareMaps(truthMap_, estimate, options_.voxelSize);
  if (errors) *errors = mapErrors(truthMap_, comparison, origin_);
  report.map = MapReport{comparison.score, lossTable(truthMap_, estimate, comparison), mapRemoval_};
  report.mapPoints = mapPoints_;
  report.mapPointsWithoutReturn = mapTruth_->unseenPoints();
}

void RunScorer::reportBounds(EvaluationReport& report) {
  for (const Bound& bound : kBounds) {
    if ((bound.ofInstances && files_.instances.empty()) ||
        (bound.ofLabels && files_.labels.empty())) {
      continue;
    }
    const MapReport map = compare(bound.map, nullptr);
    report.bounds.push_back({bound.name, map.rates, map.losses});
  }
}

void RunScorer::reportTracking(const std::filesystem::path& trueTracks,
                               EvaluationReport& report) const {
  if (!files_.labels.empty()) report.tracking = trackingReport(tracking_);
  if (trueTracks.empty() || files_.tracks.empty()) return;
  report.boxTracking = trackingReport(trackingScansFromBoxes(
      readTracksCsv(trueTracks), readTracksCsv(files_.tracks), scanIndices_, options_));
}

}  // namespace toss
