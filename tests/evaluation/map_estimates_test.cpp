// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/evaluation/MapEstimates.h>

#include <stdexcept>

#include "BruteForce.h"

namespace toss::test {
namespace {

LabelledCloud members(const LabelledCloud& cloud, const std::vector<std::uint16_t>& membership,
                      std::uint16_t bit) {
  LabelledCloud result;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (membership[i] & bit) result.add(cloud.x[i], cloud.y[i], cloud.z[i], cloud.label[i]);
  }
  return result;
}

TEST(MapEstimates, EqualMapsThatAreMadeOneByOne) {
  std::mt19937 random(3);
  constexpr int kMaps = 4;
  MapEstimates estimates(0.2, kMaps);
  std::vector<LabelledCloud> joined(kMaps);
  for (int scan = 0; scan < 4; ++scan) {
    const LabelledCloud cloud = randomCloud(random, 200, 0.8, 0.01);
    std::vector<std::uint16_t> membership(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      // Map 1 keeps everything, map 2 what is static, map 3 a random half.
      const bool isStatic = cloud.label[i] == 9u;
      membership[i] = static_cast<std::uint16_t>(3 | (isStatic ? 4 : 0) | (random() % 2 ? 8 : 0));
    }
    CellOrder order;
    orderByCell(cloud, 0.2, order);
    estimates.addScan(order, cloud.label, membership);
    for (int e = 0; e < kMaps; ++e) {
      const auto kept = members(cloud, membership, MapEstimates::bit(e));
      append(voxelizeByTryingAll(kept, 0.2), joined[static_cast<std::size_t>(e)]);
    }
  }
  for (int e = 0; e < kMaps; ++e) {
    const LabelledCloud expected = voxelizeByTryingAll(joined[static_cast<std::size_t>(e)], 0.2);
    EXPECT_TRUE(estimates.voxelized(e) == expected) << "map " << e;
  }
  EXPECT_TRUE(estimates.voxelized(0) == estimates.voxelized(1));
}

class OneAxis : public testing::TestWithParam<int> {};

TEST_P(OneAxis, IsEnoughToTellTheVoxelsOfTwoMapsApart) {
  LabelledCloud cloud;
  std::array<float, 3> p{0.1f, 0.1f, 0.1f};
  cloud.add(p[0], p[1], p[2], 9);
  p[static_cast<std::size_t>(GetParam())] = 0.15f;
  cloud.add(p[0], p[1], p[2], 9);
  CellOrder order;
  orderByCell(cloud, 0.2, order);
  MapEstimates estimates(0.2, 2);
  estimates.addScan(order, cloud.label, {1, 3});
  const LabelledCloud both = estimates.voxelized(0), one = estimates.voxelized(1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.x[0], p[0]);
  EXPECT_EQ(one.y[0], p[1]);
  EXPECT_EQ(one.z[0], p[2]);
  EXPECT_FALSE(both == one);
}

INSTANTIATE_TEST_SUITE_P(XYZ, OneAxis, testing::Range(0, 3));

TEST(MapEstimates, RefuseAnEstimateThatHoldsMoreThanTheTruth) {
  LabelledCloud cloud;
  cloud.add(0, 0, 0, 9);
  CellOrder order;
  orderByCell(cloud, 0.2, order);
  MapEstimates estimates(0.2, 2);
  EXPECT_THROW(estimates.addScan(order, cloud.label, {2}), std::logic_error);
}

TEST(MapEstimates, RefuseMoreMapsThanBits) {
  EXPECT_THROW(MapEstimates(0.2, 17), std::logic_error);
  EXPECT_THROW(MapEstimates(0.2, 0), std::logic_error);
}

}  // namespace
}  // namespace toss::test
