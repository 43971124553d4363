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

}  // namespace
}  // namespace toss
