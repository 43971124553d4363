// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <toss/evaluation/MapTruth.h>

#include <limits>

#include "BruteForce.h"

namespace toss::test {
namespace {

constexpr std::uint32_t kUnseen = 7;

/// Returns with a third of the labels 0, "not annotated".
LabelledCloud randomReturns(std::mt19937& random, double quantum) {
  LabelledCloud returns = randomCloud(random, 60, 0.5, quantum);
  for (std::uint32_t& label : returns.label) label = random() % 3 == 0 ? 0u : label;
  return returns;
}

LabelledCloud annotatedOf(const LabelledCloud& cloud) {
  LabelledCloud result;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.label[i] != 0) result.add(cloud.x[i], cloud.y[i], cloud.z[i], cloud.label[i]);
  }
  return result;
}

std::uint32_t nearestLabel(const LabelledCloud& map, std::size_t i, const LabelledCloud& returns) {
  const int nearest = nearestByTryingAll(map, i, returns, 0.2);
  return nearest < 0 ? kUnseen : returns.label[static_cast<std::size_t>(nearest)];
}

std::uint32_t labelByTryingAll(const LabelledCloud& map, std::size_t i,
                               const LabelledCloud& returns, bool ignoreUnlabelled) {
  const std::uint32_t label = nearestLabel(map, i, returns);
  if (!ignoreUnlabelled || label != 0) return label;
  return nearestLabel(map, i, annotatedOf(returns)) == 9u ? 9u : 0u;
}

class RandomMapTruth : public testing::TestWithParam<unsigned> {};

TEST_P(RandomMapTruth, EqualsTryingAll) {
  std::mt19937 random(GetParam());
  const double quantum = GetParam() % 2 ? 0.01 : 0.05;
  const bool ignoreUnlabelled = GetParam() % 3 != 0;
  const LabelledCloud map = randomCloud(random, 150, 0.5, quantum);
  MapTruth truth(map, 0.2, ignoreUnlabelled);
  LabelledCloud all;
  for (int scan = 0; scan < 3; ++scan) {
    const LabelledCloud returns = randomReturns(random, quantum);
    CellOrder order;
    orderByCell(returns, 0.2, order);
    std::vector<double> squared;
    truth.addScan(order, returns.label, squared);
    append(returns, all);
  }
  const LabelledCloud labelled = truth.labelled(kUnseen);
  std::uint64_t unseen = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    unseen += nearestLabel(map, i, all) == kUnseen;
    ASSERT_EQ(labelled.label[i], labelByTryingAll(map, i, all, ignoreUnlabelled)) << "point " << i;
  }
  EXPECT_EQ(truth.unseenPoints(), unseen);
}

TEST_P(RandomMapTruth, GivesTheDistanceOfEveryReturnToTheMap) {
  std::mt19937 random(GetParam());
  const LabelledCloud map = randomCloud(random, 150, 0.5, 0.01);
  const LabelledCloud returns = randomReturns(random, 0.01);
  CellOrder order;
  orderByCell(returns, 0.2, order);
  std::vector<double> squared;
  MapTruth(map, 0.2, true).addScan(order, returns.label, squared);
  ASSERT_EQ(squared.size(), returns.size());
  for (std::size_t place = 0; place < order.places(); ++place) {
    const int nearest = nearestByTryingAll(returns, order.index[place], map, 0.2);
    if (nearest < 0) continue;
    EXPECT_DOUBLE_EQ(squared[place], distanceSquared(returns, order.index[place], map,
                                                     static_cast<std::size_t>(nearest)));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMapTruth, testing::Range(0u, 12u));

TEST(MapTruth, LeavesOpenWhatStandsBesideAMover) {
  LabelledCloud map, returns;
  map.add(0, 0, 0, 0);
  returns.add(0.01f, 0, 0, 0);   // not annotated
  returns.add(0.1f, 0, 0, 252);  // the nearest annotated one moves
  returns.add(0.15f, 0, 0, 9);
  CellOrder order;
  orderByCell(returns, 0.2, order);
  std::vector<double> squared;
  MapTruth truth(map, 0.2, true);
  truth.addScan(order, returns.label, squared);
  EXPECT_THAT(truth.labelled(kUnseen).label, testing::ElementsAre(0u));
}

}  // namespace
}  // namespace toss::test
