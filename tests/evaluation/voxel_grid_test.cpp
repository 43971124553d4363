// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <toss/evaluation/VoxelGrid.h>

#include <limits>

#include "BruteForce.h"

namespace toss::test {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

class RandomVoxelGrid : public testing::TestWithParam<int> {};

TEST_P(RandomVoxelGrid, EqualsTryingAll) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  // Coarse quanta make many equal distances, fine ones many centroids.
  const double quantum = GetParam() % 2 == 0 ? 0.05 : 0.001;
  const LabelledCloud cloud = randomCloud(random, 400, 0.6, quantum);
  EXPECT_TRUE(voxelize(cloud, 0.2) == voxelizeByTryingAll(cloud, 0.2));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomVoxelGrid, testing::Range(0, 20));

TEST(VoxelGrid, TakesCentroidsOfFlooredVoxels) {
  LabelledCloud cloud;
  cloud.add(0.05f, 0.05f, 0.05f, 9);
  cloud.add(0.15f, 0.05f, 0.05f, 9);
  cloud.add(-0.05f, 0.05f, 0.05f, 9);  // floor, not truncation: another voxel
  const LabelledCloud voxels = voxelize(cloud, 0.2);
  EXPECT_THAT(voxels.x, ElementsAre(FloatEq(-0.05f), FloatEq(0.1f)));
}

TEST(VoxelGrid, OrdersXFastestAndZSlowest) {
  LabelledCloud cloud;
  for (const auto& [x, y, z] : std::vector<std::array<float, 3>>{
           {0.1f, 0.1f, 0.3f}, {0.1f, 0.3f, 0.1f}, {0.3f, 0.1f, 0.1f}, {0.1f, 0.1f, 0.1f}}) {
    cloud.add(x, y, z, 9);
  }
  const LabelledCloud voxels = voxelize(cloud, 0.2);
  EXPECT_THAT(voxels.x, ElementsAre(0.1f, 0.3f, 0.1f, 0.1f));
  EXPECT_THAT(voxels.y, ElementsAre(0.1f, 0.1f, 0.3f, 0.1f));
  EXPECT_THAT(voxels.z, ElementsAre(0.1f, 0.1f, 0.1f, 0.3f));
}

TEST(VoxelGrid, TakesTheLabelOfTheNearestPointEvenFromAnotherVoxel) {
  LabelledCloud cloud;
  cloud.add(0.01f, 0.01f, 0.01f, 9);
  cloud.add(0.01f, 0.19f, 0.01f, 9);
  cloud.add(-0.02f, 0.10f, 0.01f, 252);  // in another voxel, 3 cm from the centroid of the first
  const LabelledCloud voxels = voxelize(cloud, 0.2);
  EXPECT_THAT(voxels.label, ElementsAre(252u, 252u));
}

TEST(VoxelGrid, BreaksTiesByLowestIndex) {
  LabelledCloud cloud;
  cloud.add(0.125f, 0.0625f, 0.0625f, 252);
  cloud.add(0.0625f, 0.0625f, 0.0625f, 9);
  EXPECT_THAT(voxelize(cloud, 0.25).label, ElementsAre(252u));
}

TEST(VoxelGrid, LeavesOutWhatIsNotFiniteOrOutOfReach) {
  LabelledCloud cloud;
  cloud.add(std::numeric_limits<float>::quiet_NaN(), 0, 0, 9);
  cloud.add(std::numeric_limits<float>::infinity(), 0, 0, 9);
  cloud.add(0, 1e30f, 0, 9);
  cloud.add(1, 2, 3, 252);
  const LabelledCloud voxels = voxelize(cloud, 0.2);
  EXPECT_THAT(voxels.x, ElementsAre(1.0f));
  EXPECT_THAT(voxels.label, ElementsAre(252u));
}

TEST(VoxelGrid, OfNothingIsNothing) {
  EXPECT_TRUE(voxelize(LabelledCloud(), 0.2).empty());
}

}  // namespace
}  // namespace toss::test
