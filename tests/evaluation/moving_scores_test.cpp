// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/MovingScores.h>

#include <cmath>
#include <random>

namespace toss::test {
namespace {

constexpr std::uint32_t object(std::uint32_t trueClass, std::uint32_t instance) {
  return instance << 16 | trueClass;
}

MovingScores scoreOf(const std::vector<std::uint32_t>& truth,
                     const std::vector<std::uint32_t>& called, const std::vector<float>& range) {
  MovingScores scores;
  scores.addScan(truth, called, range);
  return scores;
}

TEST(MovingScores, CountOnlyAnnotatedPoints) {
  // Not annotated and outlier called moving; static called moving; moving called so; moving missed
  // as static, and as "no valid return".
  const MovingScores scores =
      scoreOf({0, 1, 40, 252, 253, 258}, {251, 251, 251, 251, 9, 0}, {1, 1, 1, 1, 1, 1});
  EXPECT_EQ(scores.all.truePositives, 1u);
  EXPECT_EQ(scores.all.falsePositives, 1u);
  EXPECT_EQ(scores.all.falseNegatives, 2u);
  EXPECT_DOUBLE_EQ(scores.all.intersectionOverUnion(), 0.25);
  EXPECT_DOUBLE_EQ(scores.all.precision(), 0.5);
  EXPECT_DOUBLE_EQ(scores.all.recall(), 1.0 / 3.0);
}

TEST(MovingScores, TakeAllMovingClassesOfOtherMethods) {
  const MovingScores scores = scoreOf({252, 252, 252}, {251, 259, 260}, {1, 1, 1});
  EXPECT_EQ(scores.all.truePositives, 2u);
}

TEST(MovingScores, TellBandsOfRangeApart) {
  EXPECT_EQ(rangeBand(0.0f), 0);
  EXPECT_EQ(rangeBand(19.99f), 0);
  EXPECT_EQ(rangeBand(20.0f), 1);
  EXPECT_EQ(rangeBand(40.0f), 2);
  EXPECT_EQ(rangeBand(60.0f), 3);
  const MovingScores scores = scoreOf({252, 252, 252}, {251, 9, 251}, {5, 25, 45});
  EXPECT_DOUBLE_EQ(scores.byRange[0].recall(), 1.0);
  EXPECT_DOUBLE_EQ(scores.byRange[1].recall(), 0.0);
  EXPECT_DOUBLE_EQ(scores.byRange[2].recall(), 1.0);
  EXPECT_TRUE(std::isnan(scores.byRange[3].recall()));
}

TEST(MovingScores, CountByTrueClass) {
  const MovingScores scores =
      scoreOf({252, 252, 10, object(10, 3)}, {251, 9, 251, 9}, {1, 1, 1, 1});
  ASSERT_EQ(scores.byClass.size(), 2u);
  EXPECT_EQ(scores.byClass.at(252).points, 2u);
  EXPECT_EQ(scores.byClass.at(252).calledMoving, 1u);
  EXPECT_EQ(scores.byClass.at(10).points, 2u);
  EXPECT_EQ(scores.byClass.at(10).calledMoving, 1u);
}

TEST(MovingScores, FindObjectsOfWhichHalfIsCalledMoving) {
  const std::uint32_t found = object(252, 1), missed = object(254, 1);
  const MovingScores scores = scoreOf({found, found, missed, missed, missed, 252},
                                      {251, 9, 251, 9, 9, 9}, {19, 22, 10, 10, 10, 10});
  EXPECT_EQ(scores.objectsByRange[1].objects, 1u);  // mean distance 20.5 m
  EXPECT_EQ(scores.objectsByRange[1].found, 1u);
  EXPECT_EQ(scores.objectsByRange[0].objects, 1u);  // without instance number: no object
  EXPECT_EQ(scores.objectsByRange[0].found, 0u);
}

TEST(MovingScores, OfBandsAddUpToTheWhole) {
  std::mt19937 random(5);
  const std::vector<std::uint32_t> classes = {0, 1, 9, 40, 252, 254, 258};
  std::vector<std::uint32_t> truth, called;
  std::vector<float> range;
  for (int i = 0; i < 2000; ++i) {
    truth.push_back(classes[random() % classes.size()]);
    called.push_back(random() % 2 ? 251u : 9u);
    range.push_back(static_cast<float>(random() % 8000) / 100.0f);
  }
  const MovingScores scores = scoreOf(truth, called, range);
  MovingCounts sum;
  for (const MovingCounts& band : scores.byRange) {
    sum.truePositives += band.truePositives, sum.falsePositives += band.falsePositives;
    sum.falseNegatives += band.falseNegatives;
  }
  std::uint64_t calledMoving = 0;
  for (const auto& [trueClass, counts] : scores.byClass) calledMoving += counts.calledMoving;
  EXPECT_EQ(sum.truePositives, scores.all.truePositives);
  EXPECT_EQ(sum.falsePositives, scores.all.falsePositives);
  EXPECT_EQ(sum.falseNegatives, scores.all.falseNegatives);
  EXPECT_EQ(calledMoving, scores.all.truePositives + scores.all.falsePositives);
  EXPECT_GT(scores.all.truePositives, 0u);
}

}  // namespace
}  // namespace toss::test
