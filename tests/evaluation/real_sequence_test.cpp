// SPDX-License-Identifier: BSD-3-Clause
#include "SyntheticRun.h"

namespace toss::test {
namespace {

/// Every tenth scan of the real sequence, labelled by a rule.
class RealSequence : public testing::Test {
 protected:
  void SetUp() override {
    if (dataFolder().empty()) GTEST_SKIP() << "no real data: set TOSS_TEST_DATA to its folder";
    truth_ = dataFolder() / "kitti-tracking-0000";
    options_.stride = 10;
  }

  EvaluationReport score(const LabelRule& rule) {
    for (std::uint64_t s = 0; s < 100; s += 10) {
      const fs::path file = labelPath(truth_ / "labels", s);
      std::vector<std::uint32_t> labels = readLabels(file, fs::file_size(file) / 4);
      for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = rule(s, i, labels[i]);
      fs::create_directories(folder_ / "labels");
      writeLabels(labelPath(folder_ / "labels", s), labels);
    }
    return evaluate(truth_, folder_ / "labels", options_);
  }

  TemporaryFolder folder_;
  fs::path truth_;
  EvaluationOptions options_;
};

TEST_F(RealSequence, KeptAsItIsScores100And0OnAnnotatedReturns) {
  const EvaluationReport report = score(naive);
  EXPECT_EQ(report.scans, 10u);
  EXPECT_TRUE(report.unlabelledIgnored);
  EXPECT_DOUBLE_EQ(report.labels->rates.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->rates.rejectionRate(), 0.0);
}

TEST_F(RealSequence, LabelledPerfectlyScores100And100OnAnnotatedReturns) {
  const EvaluationReport report = score(perfect);
  EXPECT_NEAR(report.labels->rates.preservationRate(), 100.0, 0.01);
  EXPECT_NEAR(report.labels->rates.rejectionRate(), 100.0, 0.01);
  EXPECT_GT(report.labels->rates.movingVoxels, 500u);
  EXPECT_GT(report.labels->rates.staticVoxels, 20000u);
  EXPECT_DOUBLE_EQ(report.moving->all.intersectionOverUnion(), 1.0);
  EXPECT_DOUBLE_EQ(report.tracking->clear.accuracy(), 1.0);
}

}  // namespace
}  // namespace toss::test
