// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/PreservationRejection.h>
#include <toss/evaluation/VoxelGrid.h>

#include <cmath>

#include "BruteForce.h"

namespace toss::test {
namespace {

LabelledCloud onlyStatic(const LabelledCloud& cloud) {
  LabelledCloud result;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.label[i] == 9u) result.add(cloud.x[i], cloud.y[i], cloud.z[i], 9);
  }
  return result;
}

LabelledCloud onePoint(float x, std::uint32_t label) {
  LabelledCloud cloud;
  cloud.add(x, 0, 0, label);
  return cloud;
}

/// PR and RR from their definition, every pair tried.
std::pair<double, double> ratesByTryingAll(const LabelledCloud& truth,
                                           const LabelledCloud& estimate, double voxelSize) {
  double still = 0, stillKept = 0, moving = 0, movingLeft = 0;
  for (std::size_t g = 0; g < truth.size(); ++g) {
    const int e = nearestByTryingAll(truth, g, estimate, voxelSize * std::sqrt(3.0) / 2.0);
    const std::uint32_t other = e < 0 ? 0 : estimate.label[static_cast<std::size_t>(e)];
    if (truth.label[g] == 9u) {
      still += 1, stillKept += other == 9u;
    } else {
      moving += 1, movingLeft += other == 252u;
    }
  }
  return {100.0 * stillKept / still, 100.0 * (1.0 - movingLeft / moving)};
}

class RandomMaps : public testing::TestWithParam<int> {};

TEST_P(RandomMaps, ScoreAsByTryingAll) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const LabelledCloud truth = voxelize(randomCloud(random, 500, 1.0, 0.01), 0.2);
  const LabelledCloud estimate = voxelize(randomCloud(random, 300, 1.0, 0.01), 0.2);
  const PreservationRejection score = compareMaps(truth, estimate, 0.2).score;
  const auto [preservation, rejection] = ratesByTryingAll(truth, estimate, 0.2);
  EXPECT_NEAR(score.preservationRate(), preservation, 1e-9);
  EXPECT_NEAR(score.rejectionRate(), rejection, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMaps, testing::Range(0, 20));

TEST(PreservationRejection, OfTheTruthItselfIs100And0) {
  std::mt19937 random(1);
  const LabelledCloud truth = voxelize(randomCloud(random, 500, 1.0, 0.01), 0.2);
  const PreservationRejection score = compareMaps(truth, truth, 0.2).score;
  EXPECT_DOUBLE_EQ(score.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(score.rejectionRate(), 0.0);
  EXPECT_DOUBLE_EQ(score.f1(), 0.0);
}

TEST(PreservationRejection, OfTheStaticVoxelsAloneIs100And100) {
  std::mt19937 random(2);
  const LabelledCloud truth = voxelize(randomCloud(random, 500, 1.0, 0.01), 0.2);
  const PreservationRejection score = compareMaps(truth, onlyStatic(truth), 0.2).score;
  EXPECT_DOUBLE_EQ(score.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(score.rejectionRate(), 100.0);
  EXPECT_DOUBLE_EQ(score.f1(), 1.0);
}

TEST(PreservationRejection, OfAnEmptyMapIs0And100) {
  std::mt19937 random(3);
  const LabelledCloud truth = voxelize(randomCloud(random, 500, 1.0, 0.01), 0.2);
  const PreservationRejection score = compareMaps(truth, {}, 0.2).score;
  EXPECT_DOUBLE_EQ(score.preservationRate(), 0.0);
  EXPECT_DOUBLE_EQ(score.rejectionRate(), 100.0);
}

TEST(PreservationRejection, CountsMixedPairsForNeither) {
  const MapComparison lost = compareMaps(onePoint(0, 9), onePoint(0.1f, 252), 0.2);
  EXPECT_EQ(lost.score.staticKept, 0u);
  EXPECT_EQ(lost.fate[0], VoxelFate::Lost);
  const MapComparison removed = compareMaps(onePoint(0, 252), onePoint(0.1f, 9), 0.2);
  EXPECT_EQ(removed.score.movingLeft, 0u);
  EXPECT_EQ(removed.fate[0], VoxelFate::Removed);
}

TEST(PreservationRejection, TakesInliersNearerThanHalfTheDiagonal) {
  EXPECT_EQ(compareMaps(onePoint(0, 9), onePoint(0.1732f, 9), 0.2).score.staticKept, 1u);
  EXPECT_EQ(compareMaps(onePoint(0, 9), onePoint(0.1733f, 9), 0.2).score.staticKept, 0u);
}

TEST(PreservationRejection, IsUndefinedWithoutVoxelsOfTheKind) {
  EXPECT_TRUE(std::isnan(compareMaps(onePoint(0, 9), onePoint(0, 9), 0.2).score.rejectionRate()));
  EXPECT_TRUE(
      std::isnan(compareMaps(onePoint(0, 252), onePoint(0, 9), 0.2).score.preservationRate()));
  EXPECT_TRUE(std::isnan(compareMaps(onePoint(0, 9), onePoint(0, 9), 0.2).score.f1()));
}

TEST(PreservationRejection, GivesF1AsTheHarmonicMeanOfPublishedRates) {
  const auto f1 = [](double preservation, double rejection) {
    PreservationRejection score;
    score.staticVoxels = score.movingVoxels = 100000;
    score.staticKept = static_cast<std::uint64_t>(std::lround(preservation * 1000));
    score.movingLeft = 100000 - static_cast<std::uint64_t>(std::lround(rejection * 1000));
    return score.f1();
  };
  EXPECT_NEAR(f1(99.871, 80.700), 0.893, 5e-4);
  EXPECT_NEAR(f1(83.527, 93.733), 0.883, 5e-4);
  EXPECT_NEAR(f1(34.568, 99.979), 0.514, 5e-4);
}

TEST(MapErrors, SortVoxelsByFateInTheMapFrame) {
  LabelledCloud truth, estimate;
  truth.add(0, 0, 0, 9), truth.add(1, 0, 0, 9), truth.add(2, 0, 0, 252), truth.add(3, 0, 0, 252);
  estimate.add(0, 0, 0, 9), estimate.add(3, 0, 0, 252);
  const MapErrors errors =
      mapErrors(truth, compareMaps(truth, estimate, 0.2), Eigen::Vector3d(100, 200, 300));
  ASSERT_EQ(errors.kept.size(), 1u);
  ASSERT_EQ(errors.lost.size(), 1u);
  ASSERT_EQ(errors.removed.size(), 1u);
  ASSERT_EQ(errors.residue.size(), 1u);
  EXPECT_EQ(errors.kept[0].x, 100.0f);
  EXPECT_EQ(errors.lost[0].x, 101.0f);
  EXPECT_EQ(errors.removed[0].x, 102.0f);
  EXPECT_EQ(errors.residue[0].x, 103.0f);
  EXPECT_EQ(errors.residue[0].y, 200.0f);
  EXPECT_EQ(errors.residue[0].z, 300.0f);
}

}  // namespace
}  // namespace toss::test
