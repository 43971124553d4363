// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/Evaluation.h>
#include <toss/rawlog/InputOptions.h>

#include <nlohmann/json.hpp>

#include "CrossingLog.h"

namespace toss::test {
namespace {

/// What moves is gone and what stays is there, against the simulator's truth.
class Scores : public CrossingLog {
 protected:
  static EvaluationReport scores(const fs::path& runFolder) {
    EvaluationOptions options;
    options.bounds = false;
    return evaluateRun(rawlog(), runFolder, options, InputOptions());
  }
};

TEST_F(Scores, MoversAreGoneAndTheRestStays) {
  const EvaluationReport report = scores(run());
  ASSERT_TRUE(report.labels && report.map && report.moving);
  EXPECT_EQ(report.scans, kScans);
  EXPECT_GE(report.labels->rates.preservationRate(), 99.5);
  EXPECT_GE(report.labels->rates.rejectionRate(), 88.0);
  EXPECT_GE(report.map->rates.preservationRate(), 99.5);
  EXPECT_GE(report.map->rates.rejectionRate(), 88.0);
  EXPECT_GE(report.moving->all.recall(), 0.9);
  EXPECT_GE(report.moving->all.precision(), 0.95);
}

TEST_F(Scores, LiveLabelsFindMoversToo) {
  const EvaluationReport report = scores(map(rawlog(), "live", "--no-snapshots --live-labels"));
  ASSERT_TRUE(report.liveMoving);
  EXPECT_GE(report.liveMoving->all.recall(), 0.5);
  EXPECT_GE(report.liveMoving->all.precision(), 0.9);
}

TEST_F(Scores, AMapWithoutRemovalScoresWorse) {
  const fs::path raw = in("raw");
  map(rawlog(), "raw", "--no-snapshots --set map.voxel_size=0");
  const EvaluationReport cleaned = scores(raw);
  // Everything is put back: the truth with the movers in.
  for (const auto& [name, bytes] : filesIn(raw / "labels")) {
    std::string still(bytes.size(), '\0');
    for (std::size_t i = 0; i < still.size(); i += 4) still[i] = 9;
    writeBytes(raw / "labels" / name, still);
  }
  const EvaluationReport full = scores(raw);
  EXPECT_EQ(full.labels->rates.rejectionRate(), 0.0);
  EXPECT_GT(cleaned.labels->rates.f1(), full.labels->rates.f1());
}

TEST_F(Scores, EvalWritesTheSameScoresAsJson) {
  const ProgramRun eval = runProgram("eval " + quoted(rawlog()) + " " + quoted(run()) + " --json " +
                                     quoted(in("scores.json")));
  EXPECT_EQ(eval.code, 0) << eval.error;
  EXPECT_THAT(eval.out, ::testing::HasSubstr("RR"));
  EXPECT_FALSE(nlohmann::json::parse(readBytes(in("scores.json"))).empty());
}

}  // namespace
}  // namespace toss::test
