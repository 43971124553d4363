// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <toss/evaluation/NearestNeighbors.h>

#include "BruteForce.h"

namespace toss::test {
namespace {

std::vector<std::int32_t> nearest(const LabelledCloud& queries, const LabelledCloud& targets,
                                  double radius, double cellSize) {
  CellOrder queryOrder, targetOrder;
  orderByCell(queries, cellSize, queryOrder);
  orderByCell(targets, cellSize, targetOrder);
  return nearestNeighbors(queryOrder, targetOrder, radius, queries.size());
}

class RandomNeighbors : public testing::TestWithParam<int> {};

TEST_P(RandomNeighbors, EqualTryingAll) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  const double quantum = GetParam() % 2 == 0 ? 0.05 : 0.001;
  const LabelledCloud queries = randomCloud(random, 200, 0.8, quantum);
  const LabelledCloud targets = randomCloud(random, 100, 0.8, quantum);
  const double radius = GetParam() % 3 == 0 ? 0.2 : 0.15;
  const std::vector<std::int32_t> found = nearest(queries, targets, radius, 0.2);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    ASSERT_EQ(found[i], nearestByTryingAll(queries, i, targets, radius)) << "query " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomNeighbors, testing::Range(0, 20));

TEST(NearestNeighbors, DemandsLessThanTheRadius) {
  LabelledCloud query, target;
  query.add(0, 0, 0, 9);
  target.add(0.125f, 0, 0, 9);
  EXPECT_THAT(nearest(query, target, 0.125, 0.25), testing::ElementsAre(-1));
  EXPECT_THAT(nearest(query, target, 0.1250001, 0.25), testing::ElementsAre(0));
}

TEST(NearestNeighbors, FindNothingInNothing) {
  LabelledCloud query;
  query.add(0, 0, 0, 9);
  EXPECT_THAT(nearest(query, {}, 0.2, 0.2), testing::ElementsAre(-1));
  EXPECT_TRUE(nearest({}, query, 0.2, 0.2).empty());
}

TEST(LowerBoundFrom, EqualsSearchFromTheFront) {
  std::mt19937 random(7);
  std::vector<CellKey> keys(500);
  for (CellKey& key : keys) key = random() % 2000;
  std::sort(keys.begin(), keys.end());
  for (CellKey wanted = 0; wanted < 2001; ++wanted) {
    const auto expected =
        static_cast<std::size_t>(std::lower_bound(keys.begin(), keys.end(), wanted) - keys.begin());
    for (std::size_t start = 0; start <= expected; start += 1 + start / 3) {
      ASSERT_EQ(lowerBoundFrom(keys, start, wanted), expected) << wanted << " from " << start;
    }
  }
}

TEST(NeighborKey, WrapsNowhereBetweenNegativeAndPositiveCells) {
  LabelledCloud a, b;
  for (int i = 0; i < 27; ++i) {
    a.add(-0.01f, -0.01f, -0.01f, 9);
    b.add(i % 3 == 0   ? -0.11f
          : i % 3 == 1 ? -0.01f
                       : 0.09f,
          i / 3 % 3 == 0   ? -0.11f
          : i / 3 % 3 == 1 ? -0.01f
                           : 0.09f,
          i / 9 == 0   ? -0.11f
          : i / 9 == 1 ? -0.01f
                       : 0.09f,
          9);
  }
  CellOrder one, all;
  orderByCell(a, 0.1, one);
  orderByCell(b, 0.1, all);
  std::uint32_t met = 0;
  joinCells(one, all,
            [&](std::size_t, std::uint32_t first, std::uint32_t end) { met += end - first; });
  EXPECT_EQ(met, 27u);
}

}  // namespace
}  // namespace toss::test
