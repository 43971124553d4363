// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/mapping/VoxelKey.h>

namespace toss {
namespace {

using Index = std::array<std::int32_t, 3>;

TEST(VoxelKey, RoundTripIncludesTheEndsAndNegativeIndices) {
  const std::int32_t ends[] = {-kVoxelReach, -2, -1, 0, 1, kVoxelReach - 1};
  for (const std::int32_t x : ends) {
    for (const std::int32_t y : ends) {
      for (const std::int32_t z : ends) {
        EXPECT_EQ(voxelIndex(voxelKey(x, y, z)), (Index{x, y, z}));
      }
    }
  }
}

TEST(VoxelKey, CubesBeginAtTheirFirstVoxel) {
  EXPECT_EQ(cubeOf(voxelKey(-1, 11, 2), 2), voxelKey(-4, 8, 0));
  EXPECT_EQ(cubeOf(voxelKey(-1, 11, 2), 4), voxelKey(-16, 0, 0));
  EXPECT_EQ(cubeOf(voxelKey(-1, 11, 2), kVoxelKeyBits), 0u);
}

TEST(VoxelKey, PlacesInABlockAreXBeforeYBeforeZ) {
  const VoxelKey block = voxelKey(-4, 8, 1020);
  std::uint64_t place = 0;
  for (std::int32_t x = -4; x < 0; ++x)
    for (std::int32_t y = 8; y < 12; ++y)
      for (std::int32_t z = 1020; z < 1024; ++z) {
        EXPECT_EQ(placeInBlock(voxelKey(x, y, z)), place);
        EXPECT_EQ(voxelInBlock(block, place++), voxelKey(x, y, z));
      }
}

TEST(VoxelKey, CubesOfBricksAreRunsOfPlacesInTheMap) {
  for (int cube = 0; cube < 3; ++cube) {
    const int edge = kBrickVoxels << cube;
    const std::uint64_t size = std::uint64_t{64} << 3 * cube;
    const std::uint64_t first = placeInMap(voxelKey(-edge, 2 * edge, 0));
    EXPECT_EQ(first % size, 0u);
    EXPECT_EQ(placeInMap(voxelKey(-4, 3 * edge - 4, edge - 4)), first + size - 1);
    EXPECT_EQ(placeInMap(voxelKey(-edge / 2 - 4, 2 * edge + 4, edge / 2)) / size, first / size);
    EXPECT_NE(placeInMap(voxelKey(0, 2 * edge, 0)) / size, first / size);
  }
}

TEST(VoxelKey, BlocksOfABrickFollowEachOther) {
  EXPECT_EQ(placeInMap(voxelKey(0, 0, 4)), placeInMap(voxelKey(0, 0, 0)) + 1);
  EXPECT_EQ(placeInMap(voxelKey(0, 4, 0)), placeInMap(voxelKey(0, 0, 0)) + 4);
  EXPECT_EQ(placeInMap(voxelKey(4, 0, 0)), placeInMap(voxelKey(0, 0, 0)) + 16);
}

}  // namespace
}  // namespace toss
