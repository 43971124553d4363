// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/Segmentation.h>

#include <numeric>

#include "SyntheticRun.h"

namespace toss::test {
namespace {

/// A segmentation with one flaw of each kind. The car's lower rows are labelled ground; its left
/// half above is an instance of its own, the rest melts into the wall; the truck is in no instance
/// at all, nor is the person; one car return in scan 0 is out of range.
std::uint32_t flawedSegment(std::size_t scan, std::size_t i, std::uint32_t truth) {
  const auto of = [](PointClass segment, std::uint32_t instance) {
    return instance << 16 | static_cast<std::uint32_t>(segment);
  };
  const std::uint32_t trueClass = label::semantic(truth);
  if (trueClass == kGround) return of(PointClass::Ground, 0);
  if (trueClass == kWall) return of(PointClass::Instance, 4);
  if (trueClass != kCar) return of(PointClass::Unclustered, 0);
  const std::size_t k = (i - 3000) / 2;  // car and truck returns alternate behind ground and wall
  if (scan == 0 && k == 99) return of(PointClass::OutOfRange, 0);
  if (k < 20) return of(PointClass::Ground, 0);
  return of(PointClass::Instance, k % 10 < 5 ? 3u : 4u);
}

/// The labels that an oracle per instance would write on that segmentation.
std::uint32_t oracleLabel(std::size_t scan, std::size_t i, std::uint32_t truth) {
  return label::instance(flawedSegment(scan, i, truth)) == 3 ? label::kMoving : label::kStatic;
}

class Bounds : public testing::Test {
 protected:
  Bounds() { writeTruth(scene_, truth_); }

  EvaluationReport score(const LabelRule& labels, bool withInstances) {
    writeRunLabels(scene_, run_ / "labels", labels);
    if (withInstances) writeRunLabels(scene_, run_ / "instances", flawedSegment);
    return evaluate(truth_, run_);
  }

  static const BoundReport& bound(const EvaluationReport& report, const std::string& name) {
    for (const BoundReport& b : report.bounds) {
      if (b.name == name) return b;
    }
    throw std::logic_error("no bound " + name);
  }

  static void expectSameRates(const PreservationRejection& a, const PreservationRejection& b) {
    EXPECT_EQ(a.staticVoxels, b.staticVoxels);
    EXPECT_EQ(a.staticKept, b.staticKept);
    EXPECT_EQ(a.movingVoxels, b.movingVoxels);
    EXPECT_EQ(a.movingLeft, b.movingLeft);
  }

  TemporaryFolder folder_;
  SyntheticScene scene_;
  fs::path truth_ = folder_ / "truth", run_ = folder_ / "run";
};

TEST_F(Bounds, OfInstancesEqualARunWithTheOraclesLabels) {
  const EvaluationReport report = score(oracleLabel, true);
  const BoundReport& oracle = bound(report, "oracle class per instance");
  expectSameRates(oracle.rates, report.labels->rates);
  EXPECT_GT(oracle.rates.rejectionRate(), 0.0);
  EXPECT_LT(oracle.rates.rejectionRate(), 50.0);
}

TEST_F(Bounds, NameTheCauseOfEveryVoxelLeft) {
  const EvaluationReport report = score(oracleLabel, true);
  const auto& left = bound(report, "oracle class per instance").losses.residueByCause;
  const auto count = [&](LossCause cause) { return left[static_cast<std::size_t>(cause)]; };
  EXPECT_GT(count(LossCause::Ground), 0u);
  EXPECT_GT(count(LossCause::Merged), 0u);
  EXPECT_GT(count(LossCause::NoInstance), 0u);       // the truck
  EXPECT_GT(count(LossCause::NoInstanceSmall), 0u);  // the person
  EXPECT_EQ(count(LossCause::Classification), 0u);
  EXPECT_EQ(std::accumulate(left.begin(), left.end(), std::uint64_t{0}),
            report.labels->rates.movingLeft);
}

TEST_F(Bounds, BlameTheClassifierForMoversThatAnInstanceHolds) {
  const EvaluationReport report = score(naive, true);
  const auto& left = report.labels->losses.residueByCause;
  EXPECT_GT(left[static_cast<std::size_t>(LossCause::Classification)], 0u);
  EXPECT_EQ(std::accumulate(left.begin(), left.end(), std::uint64_t{0}),
            report.labels->rates.movingVoxels);
}

TEST_F(Bounds, OfTracesJudgeTheWholeLifeOfATrace) {
  // One trace holds the car, and in the first scan the wall with it: static in that scan, moving on
  // the whole only if its car returns (600) outnumber the wall's (600 in one scan): they don't.
  const LabelRule oneTrace = [](std::size_t scan, std::size_t, std::uint32_t truth) {
    const std::uint32_t trueClass = label::semantic(truth);
    const bool inTrace = trueClass == kCar || (trueClass == kWall && scan == 0);
    return (inTrace ? 9u << 16 : 0u) | label::kStatic;
  };
  const EvaluationReport report = score(oneTrace, false);
  EXPECT_DOUBLE_EQ(bound(report, "oracle class per trace").rates.rejectionRate(), 0.0);
  const LabelRule perScan = [](std::size_t scan, std::size_t, std::uint32_t truth) {
    return label::semantic(truth) == kCar && scan > 0 ? label::kMoving : label::kStatic;
  };
  const PreservationRejection boxes = bound(report, "oracle class per trace and scan").rates;
  expectSameRates(boxes, score(perScan, false).labels->rates);
  EXPECT_GT(boxes.rejectionRate(), 0.0);
}

TEST_F(Bounds, OfPerfectLabelsDependOnTheReturnsOfAnObject) {
  const EvaluationReport report = score(naive, false);
  const auto rate = [&](const std::string& returns) {
    return bound(report, "perfect labels for objects of " + returns + " returns or more")
        .rates.rejectionRate();
  };
  // The person has four returns in each scan.
  EXPECT_DOUBLE_EQ(rate("3"), 100.0);
  EXPECT_LT(rate("5"), 100.0);
  EXPECT_DOUBLE_EQ(rate("10"), rate("5"));
}

TEST_F(Bounds, AreLeftOutWhereNotAskedFor) {
  writeRunLabels(scene_, run_ / "labels", naive);
  EvaluationOptions options;
  options.bounds = false;
  EXPECT_TRUE(evaluate(truth_, run_, options).bounds.empty());
}

}  // namespace
}  // namespace toss::test
