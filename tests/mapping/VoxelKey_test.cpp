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

TEST(VoxelKey, VoxelsOfABlockAreNextToEachOther) {
  const VoxelKey first = voxelKey(-4, 8, 0);
  EXPECT_EQ(voxelKey(-4, 8, 3), first + 3);
  EXPECT_EQ(voxelKey(-1, 11, 3), first + 63);
  EXPECT_NE(voxelKey(-4, 8, 4) >> 6, first >> 6);
}

TEST(VoxelKey, CubesOfBricksAreRunsOfKeys) {
  for (int cube = 0; cube < 3; ++cube) {
    const int edge = kBrickVoxels << cube;
    const VoxelKey size = VoxelKey{1} << (kBrickShift + 3 * cube);
    const VoxelKey first = voxelKey(-edge, 2 * edge, 0);
    EXPECT_EQ(first % size, 0u);
    EXPECT_EQ(voxelKey(-1, 3 * edge - 1, edge - 1), first + size - 1);
    EXPECT_EQ(voxelKey(-edge / 2 - 1, 2 * edge + 1, edge / 2) / size, first / size);
    EXPECT_NE(voxelKey(0, 2 * edge, 0) / size, first / size);
  }
}

}  // namespace
}  // namespace toss
