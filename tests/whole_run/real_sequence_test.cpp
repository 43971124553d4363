// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/Evaluation.h>
#include <toss/rawlog/InputOptions.h>

#include "Program.h"

namespace toss::test {
namespace {

/// Bounds against regressions on real traffic: cars and a bicycle in a city.
TEST(RealSequence, IsCleanedWell) {
  const fs::path sequence = dataFolder() / "kitti-tracking-0000";
  if (dataFolder().empty() || !fs::exists(sequence)) GTEST_SKIP() << "no real data";
  const TemporaryFolder folder;
  runWell("map " + quoted(sequence) + " --no-snapshots --to 39 --out " + quoted(folder / "run"));
  EvaluationOptions options;
  options.bounds = false;
  options.unlabelled = Unlabelled::Ignore;
  const EvaluationReport report = evaluateRun(sequence, folder / "run", options, InputOptions());
  ASSERT_TRUE(report.labels && report.moving);
  EXPECT_EQ(report.scansWithoutLabels + report.scans, filesIn(sequence / "labels").size());
  EXPECT_GE(report.labels->rates.preservationRate(), 99.0);
  EXPECT_GE(report.labels->rates.rejectionRate(), 95.0);
  EXPECT_GE(report.moving->all.intersectionOverUnion(), 0.9);
}

}  // namespace
}  // namespace toss::test
