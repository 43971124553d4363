// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/EvaluationReport.h>
#include <toss/evaluation/MapEstimates.h>
#include <toss/evaluation/MapTruth.h>
#include <toss/geometry/PosedScan.h>

#include <memory>
#include <vector>

#include "LabelSurvey.h"
#include "RunFiles.h"
#include "ScanGeometry.h"
#include "ScanMembership.h"

namespace toss {

/// Scores one run scan by scan, in two passes over the same scans; the second one only where the
/// run has labels.
class RunScorer {
 public:
  RunScorer(const RunFiles& files, const LabelSurvey& survey, const EvaluationOptions& options);

  /// First pass.
  void addScan(const PosedScan& scan, const std::vector<std::uint32_t>& truth);
  bool needsSecondPass() const { return !files_.labels.empty(); }
  void beginSecondPass() { labelRemoval_.endFirstPass(); }
  void addScanAgain(const PosedScan& scan, const std::vector<std::uint32_t>& truth);

  std::uint64_t scans() const { return scanIndices_.size(); }
  /// Fills the report's scores. `errors` as in evaluateRun(); `trueTracks`: true boxes or "".
  void report(const std::filesystem::path& trueTracks, EvaluationReport& report, MapErrors* errors);

 private:
  void loadMap();
  void readRunLabels(std::uint64_t index, std::size_t points);
  void scoreMap();
  void scoreLabels();
  /// Whether a return counts in SA and DA, and if so whether it moves.
  bool countsForRemoval(std::size_t i, bool& moving) const;
  MapReport compare(int map, MapErrors* errors);
  void reportMap(EvaluationReport& report, MapErrors* errors);
  void reportLabels(EvaluationReport& report, MapErrors* errors);
  void reportBounds(EvaluationReport& report);
  void reportTracking(const std::filesystem::path& trueTracks, EvaluationReport& report) const;

  const RunFiles& files_;
  const LabelSurvey& survey_;
  const EvaluationOptions& options_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<std::uint64_t> scanIndices_;
  std::uint64_t points_ = 0;

  ScanGeometry geometry_;
  ScanLabelSets labels_;
  ScanMembership membership_;
  CellOrder order_, keptOrder_;
  std::vector<double> squaredDistanceToMap_;

  MapEstimates estimates_;
  LabelledCloud truthMap_;
  std::unique_ptr<MapTruth> mapTruth_;
  std::uint64_t mapPoints_ = 0;
  RemovalAccuracy mapRemoval_;
  LabelRemovalAccuracy labelRemoval_;
  MovingScores moving_, liveMoving_;
  std::vector<TrackingScan> tracking_;
};

}  // namespace toss
