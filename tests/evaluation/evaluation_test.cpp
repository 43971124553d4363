// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/RawlogWriter.h>

#include "SyntheticRun.h"

namespace toss::test {
namespace {

class Evaluation : public testing::Test {
 protected:
  Evaluation() { writeTruth(scene_, truth_); }

  EvaluationReport ofLabels(const LabelRule& rule, const EvaluationOptions& options = {}) {
    writeRunLabels(scene_, run_ / "labels", rule);
    return evaluate(truth_, run_, options);
  }

  /// A map of returns in the map frame, of one kind or of all.
  void writeMap(const fs::path& file, bool withMoving, const Eigen::Vector3d& shift) {
    std::vector<MapPoint> map;
    for (std::size_t s = 0; s < scene_.scans.size(); ++s) {
      const PointCloud& points = scene_.scans[s].points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (label::isMoving(scene_.truth[s][i]) && !withMoving) continue;
        const Eigen::Vector3d p =
            scene_.scans[s].mapFromSensor * Eigen::Vector3d(points.x[i], points.y[i], points.z[i]) +
            shift;
        map.push_back({float(p.x()), float(p.y()), float(p.z()), 0.0f});
      }
    }
    writePly(file, map);
  }

  TemporaryFolder folder_;
  SyntheticScene scene_;
  fs::path truth_ = folder_ / "truth", run_ = folder_ / "run";
};

TEST_F(Evaluation, OfARunThatKeepsEverythingIs100And0) {
  const EvaluationReport report = ofLabels(naive);
  EXPECT_EQ(report.scans, 6u);
  EXPECT_FALSE(report.unlabelledIgnored);
  EXPECT_DOUBLE_EQ(report.labels->rates.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->rates.rejectionRate(), 0.0);
  EXPECT_DOUBLE_EQ(report.labels->removal->staticAccuracy(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->removal->dynamicAccuracy(), 0.0);
  EXPECT_DOUBLE_EQ(report.moving->all.intersectionOverUnion(), 0.0);
  EXPECT_EQ(report.tracking->clear.matches, 0u);
}

TEST_F(Evaluation, OfPerfectLabelsIs100And100) {
  const EvaluationReport report = ofLabels(perfect);
  EXPECT_DOUBLE_EQ(report.labels->rates.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->rates.rejectionRate(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->rates.f1(), 1.0);
  EXPECT_DOUBLE_EQ(report.labels->removal->staticAccuracy(), 100.0);
  EXPECT_DOUBLE_EQ(report.labels->removal->dynamicAccuracy(), 100.0);
  EXPECT_DOUBLE_EQ(report.moving->all.intersectionOverUnion(), 1.0);
  EXPECT_DOUBLE_EQ(report.tracking->clear.accuracy(), 1.0);
  EXPECT_EQ(report.tracking->clear.trajectories, 2u);  // the person has too few returns
}

TEST_F(Evaluation, ScoresTheMapsOfOtherPrograms) {
  writeMap(folder_ / "all.ply", true, Eigen::Vector3d::Zero());
  const EvaluationReport all = evaluate(truth_, folder_ / "all.ply");
  EXPECT_DOUBLE_EQ(all.map->rates.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(all.map->rates.rejectionRate(), 0.0);
  EXPECT_DOUBLE_EQ(all.map->removal->dynamicAccuracy(), 0.0);
  EXPECT_FALSE(all.labels || all.moving || all.tracking);

  writeMap(folder_ / "clean.ply", false, Eigen::Vector3d::Zero());
  const EvaluationReport clean = evaluate(truth_, folder_ / "clean.ply");
  EXPECT_DOUBLE_EQ(clean.map->rates.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(clean.map->rates.rejectionRate(), 100.0);
  EXPECT_DOUBLE_EQ(clean.map->removal->staticAccuracy(), 100.0);
  EXPECT_DOUBLE_EQ(clean.map->removal->dynamicAccuracy(), 100.0);
  EXPECT_EQ(clean.mapPointsWithoutReturn, 0u);
  EXPECT_TRUE(clean.warnings.empty());
}

TEST_F(Evaluation, WarnsOfAMapInAnotherFrame) {
  writeMap(folder_ / "shifted.ply", false, {0.0, 0.0, 500.0});
  const EvaluationReport report = evaluate(truth_, folder_ / "shifted.ply");
  EXPECT_DOUBLE_EQ(report.map->rates.preservationRate(), 0.0);
  EXPECT_EQ(report.mapPointsWithoutReturn, report.mapPoints);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_THAT(report.warnings[0], testing::HasSubstr("frame"));
}

TEST_F(Evaluation, HoldsFarFromTheOriginOfTheMap) {
  const LabelRule halfOfTheCar = [](std::size_t, std::size_t i, std::uint32_t truth) {
    return i % 4 == 0 ? perfect(0, i, truth) : label::kStatic;
  };
  const EvaluationReport near = ofLabels(halfOfTheCar);
  const SyntheticScene far(Eigen::Vector3d(400000.0, 5600000.0, 200.0));
  writeTruth(far, folder_ / "far");
  const EvaluationReport report = evaluate(folder_ / "far", run_);
  EXPECT_EQ(report.labels->rates.staticVoxels, near.labels->rates.staticVoxels);
  EXPECT_NEAR(report.labels->rates.rejectionRate(), near.labels->rates.rejectionRate(), 0.5);
  EXPECT_NEAR(report.labels->rates.preservationRate(), near.labels->rates.preservationRate(), 0.5);
}

TEST_F(Evaluation, GivesTheSameForARawlogAsForTheFolder) {
  RawlogWriter writer(folder_ / "log.rawlog");
  for (std::size_t i = 0; i < scene_.scans.size(); ++i) {
    writer.write(scene_.scans[i], scene_.truth[i]);
  }
  writer.commit();
  EvaluationReport fromFolder = ofLabels(perfect);
  EvaluationReport fromRawlog = evaluate(folder_ / "log.rawlog", run_);
  fromRawlog.truth = fromFolder.truth;
  EXPECT_EQ(toJson(fromRawlog), toJson(fromFolder));
}

TEST_F(Evaluation, ScoresOnlyTheScansAskedFor) {
  EvaluationOptions options;
  options.from = 1, options.to = 4, options.stride = 2;
  EXPECT_EQ(ofLabels(perfect, options).scans, 2u);  // 1 and 3
}

TEST_F(Evaluation, CanOmitTheTruckClass) {
  EvaluationOptions options;
  const EvaluationReport with = ofLabels(perfect, options);
  options.omitTruckClass = true;
  const EvaluationReport without = ofLabels(perfect, options);
  EXPECT_LT(without.labels->rates.movingVoxels, with.labels->rates.movingVoxels);
  EXPECT_LT(without.labels->rates.preservationRate(), 99.0);
  EXPECT_DOUBLE_EQ(without.labels->rates.rejectionRate(), 100.0);
}

TEST_F(Evaluation, ScoresLiveLabelsBesideTheFinalOnes) {
  writeRunLabels(scene_, run_ / "live_labels", naive);
  const EvaluationReport report = ofLabels(perfect);
  EXPECT_DOUBLE_EQ(report.labels->rates.rejectionRate(), 100.0);
  EXPECT_DOUBLE_EQ(report.liveLabels->rates.rejectionRate(), 0.0);
  EXPECT_DOUBLE_EQ(report.liveMoving->all.recall(), 0.0);
}

TEST_F(Evaluation, TakesFoldersOfLabelsOfOtherMethods) {
  writeRunLabels(scene_, folder_ / "other" / "predictions", perfect);
  EXPECT_DOUBLE_EQ(evaluate(truth_, folder_ / "other").labels->rates.rejectionRate(), 100.0);
  EXPECT_DOUBLE_EQ(
      evaluate(truth_, folder_ / "other" / "predictions").labels->rates.rejectionRate(), 100.0);
}

TEST_F(Evaluation, LeavesOutScansWithoutLabelsAndSaysSo) {
  writeRunLabels(scene_, run_ / "labels", perfect);
  fs::remove(labelPath(run_ / "labels", 2));
  const EvaluationReport report = evaluate(truth_, run_);
  EXPECT_EQ(report.scans, 5u);
  EXPECT_EQ(report.scansWithoutLabels, 1u);
  ASSERT_EQ(report.warnings.size(), 1u);
}

TEST_F(Evaluation, GivesTheVoxelsByFate) {
  writeRunLabels(scene_, run_ / "labels", perfect);
  MapErrors errors;
  const EvaluationReport report = evaluate(truth_, run_, {}, &errors);
  EXPECT_EQ(errors.kept.size(), report.labels->rates.staticVoxels);
  EXPECT_EQ(errors.removed.size(), report.labels->rates.movingVoxels);
  EXPECT_TRUE(errors.lost.empty() && errors.residue.empty());
}

TEST_F(Evaluation, ReportsProgressInAscendingOrderUpToOne) {
  writeRunLabels(scene_, run_ / "labels", perfect);
  std::vector<double> shares;
  evaluateRun(truth_, run_, {}, InputOptions(), [&](double share) { shares.push_back(share); });
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace toss::test
