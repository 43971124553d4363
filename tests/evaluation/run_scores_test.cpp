// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/Evaluation.h>
#include <toss/evaluation/RunScores.h>
#include <toss/geometry/OptionSections.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/simulation/SimulateTo.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

/// A small simulated log on disk and in memory.
class SimulatedRun : public testing::Test {
 protected:
  void SetUp() override {
    SimulationOptions options;
    options.scene = "crossing", options.frames = 20;
    simulateTo(folder_ / "truth", LogFormat::Kitti, options);
    log_ = readLabelledLog(folder_ / "truth", {}, InputOptions());
  }

  /// The same run scored from label files by the evaluator.
  EvaluationReport scoreFiles(const MethodRun& run) {
    for (const char* name : {"labels", "live_labels", "instances"})
      fs::create_directories(folder_ / "run" / name);
    for (std::size_t s = 0; s < run.answers.size(); ++s) {
      const ScanAnswer& answer = run.answers[s];
      std::vector<std::uint32_t> live(answer.final.size());
      for (std::size_t i = 0; i < live.size(); ++i)
        live[i] = label::semantic(answer.final[i]) == label::kInvalid ? label::kInvalid
                  : answer.liveMoving[i]                              ? label::kMoving
                                                                      : label::kStatic;
      writeLabels(labelPath(folder_ / "run" / "labels", s), answer.final);
      writeLabels(labelPath(folder_ / "run" / "live_labels", s), live);
      writeLabels(labelPath(folder_ / "run" / "instances", s), answer.instances);
    }
    return evaluateRun(folder_ / "truth", folder_ / "run", EvaluationOptions(), InputOptions());
  }

  TemporaryFolder folder_;
  LabelledLog log_;
};

void expectEqual(const PreservationRejection& a, const PreservationRejection& b) {
  EXPECT_EQ(a.staticVoxels, b.staticVoxels);
  EXPECT_EQ(a.staticKept, b.staticKept);
  EXPECT_EQ(a.movingVoxels, b.movingVoxels);
  EXPECT_EQ(a.movingLeft, b.movingLeft);
}

TEST_F(SimulatedRun, ScoresInMemoryAsTheEvaluatorDoesFromFiles) {
  const MethodRun run = runPipeline(log_, PipelineOptions());
  const RunScores scores = scoreRun(log_, run, EvaluationOptions());
  const EvaluationReport report = scoreFiles(run);
  ASSERT_GT(scores.map.movingVoxels, 0u);
  expectEqual(scores.map, report.labels->rates);
  expectEqual(*scores.liveMap, report.liveLabels->rates);
  EXPECT_EQ(scores.moving.all.truePositives, report.moving->all.truePositives);
  EXPECT_EQ(scores.moving.all.falsePositives, report.moving->all.falsePositives);
  EXPECT_EQ(scores.liveMoving->all.truePositives, report.liveMoving->all.truePositives);
  EXPECT_EQ(scores.losses.residueByCause, report.labels->losses.residueByCause);
  ASSERT_EQ(report.bounds.size(), 6u);
  expectEqual(*scores.instanceBound, report.bounds[0].rates);
  expectEqual(*scores.traceBound, report.bounds[2].rates);
}

TEST_F(SimulatedRun, KeepingEverythingPreservesAllAndRejectsNothing) {
  const RunScores scores = scoreRun(log_, keepEverything(log_), EvaluationOptions());
  EXPECT_DOUBLE_EQ(scores.map.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(scores.map.rejectionRate(), 0.0);
  EXPECT_FALSE(scores.instanceBound.has_value());
}

TEST_F(SimulatedRun, TakesEveryStridethScanOfARange) {
  const LabelledLog part = readLabelledLog(folder_ / "truth", {3, 11, 4}, InputOptions());
  ASSERT_EQ(part.scans.size(), 3u);
  EXPECT_EQ(part.scans[0].index, 3u);
  EXPECT_EQ(part.scans[1].index, 7u);
  EXPECT_EQ(part.scans[2].index, 11u);
  EXPECT_EQ(part.labels[1], log_.labels[7]);
  EXPECT_THROW(readLabelledLog(folder_ / "truth", {20, 30, 1}, InputOptions()), UserError);
}

TEST(Quantile, IsTheValueOfThatRank) {
  EXPECT_DOUBLE_EQ(quantile({5.0, 1.0, 3.0}, 0.5), 3.0);
  EXPECT_DOUBLE_EQ(quantile({5.0, 1.0, 3.0}, 1.0), 5.0);
  EXPECT_DOUBLE_EQ(quantile({}, 0.5), 0.0);
}

}  // namespace
}  // namespace toss::test
