// SPDX-License-Identifier: BSD-3-Clause
#include "SyntheticRun.h"

namespace toss::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class EvaluationErrors : public testing::Test {
 protected:
  EvaluationErrors() {
    writeTruth(scene_, truth_);
    writeRunLabels(scene_, run_ / "labels", perfect);
  }

  std::string errorOf(const fs::path& truth, const fs::path& run,
                      const EvaluationOptions& options = {}) {
    return userErrorOf([&] { evaluate(truth, run, options); });
  }

  TemporaryFolder folder_;
  SyntheticScene scene_;
  fs::path truth_ = folder_ / "truth", run_ = folder_ / "run";
};

TEST_F(EvaluationErrors, NamePathsThatAreNotThere) {
  EXPECT_THAT(errorOf(folder_ / "nowhere", run_), HasSubstr("nowhere"));
  EXPECT_THAT(errorOf(truth_, folder_ / "norun"), HasSubstr("norun"));
}

TEST_F(EvaluationErrors, SayThatThereAreNoTrueLabels) {
  fs::remove_all(truth_ / "labels");
  EXPECT_THAT(errorOf(truth_, run_), AllOf(HasSubstr("truth"), HasSubstr("labels")));
}

TEST_F(EvaluationErrors, SayThatAFolderHoldsNothingToScore) {
  fs::create_directories(folder_ / "empty");
  EXPECT_THAT(errorOf(truth_, folder_ / "empty"), HasSubstr("static_map.ply"));
}

TEST_F(EvaluationErrors, NameTheLabelFileOfTheWrongSize) {
  writeLabels(labelPath(run_ / "labels", 3), {9, 9, 9});
  EXPECT_THAT(errorOf(truth_, run_), HasSubstr("000003.label"));
}

TEST_F(EvaluationErrors, NameAMissingLiveLabelFile) {
  writeRunLabels(scene_, run_ / "live_labels", naive);
  fs::remove(labelPath(run_ / "live_labels", 4));
  EXPECT_THAT(errorOf(truth_, run_), HasSubstr("000004.label"));
}

TEST_F(EvaluationErrors, SayThatNoScanCanBeScored) {
  EvaluationOptions options;
  options.from = 1000;
  EXPECT_THAT(errorOf(truth_, run_, options), HasSubstr("evaluation.from"));
}

TEST_F(EvaluationErrors, NameOptionsOutOfRange) {
  EvaluationOptions options;
  options.voxelSize = -1.0;
  EXPECT_THAT(errorOf(truth_, run_, options), HasSubstr("voxel_size"));
  options.voxelSize = 0.02;
  EXPECT_THAT(errorOf(truth_, run_, options), HasSubstr("removal_distance"));
}

TEST_F(EvaluationErrors, NameTheLineOfADamagedTimeTable) {
  writeBytes(run_ / "timings.csv", "scan,ground_ms\n0,1.5\n1,fast\n");
  EXPECT_THAT(errorOf(truth_, run_), AllOf(HasSubstr("line 3"), HasSubstr("fast")));
  writeBytes(run_ / "timings.csv", "scan,ground_ms\n0\n");
  EXPECT_THAT(errorOf(truth_, run_), HasSubstr("line 2"));
}

TEST_F(EvaluationErrors, SayThatASummaryIsNoJson) {
  writeBytes(run_ / "summary.json", "{\"version\": ");
  EXPECT_THAT(errorOf(truth_, run_), HasSubstr("summary.json"));
}

TEST_F(EvaluationErrors, WarnOfLabelsThatMarkEverythingInvalid) {
  writeRunLabels(scene_, run_ / "labels",
                 [](std::size_t, std::size_t, std::uint32_t) { return 0u; });
  const EvaluationReport report = evaluate(truth_, run_);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_THAT(report.warnings[0], HasSubstr("static is 9"));
  EXPECT_DOUBLE_EQ(report.labels->rates.preservationRate(), 0.0);
}

}  // namespace
}  // namespace toss::test
