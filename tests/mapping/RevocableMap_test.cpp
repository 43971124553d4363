// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/mapping/RevocableMap.h>

#include "RandomReturns.h"

namespace toss {
namespace {

using test::RandomReturns;

std::vector<VoxelRun> bin(const VoxelMap& voxels, const RandomReturns& r) {
  std::vector<VoxelRun> result;
  voxels.bin(r.level.x, r.level.y, r.level.z, r.intensity, r.sensorPosition, r.all, 50, result);
  return result;
}

TEST(RevocableMap, TraceLedgerHoldsEachVoxelOnce) {
  std::mt19937 random(1);
  RevocableMap map(MappingOptions{}, {0, 0, 0});
  const RandomReturns parked(random, 400, 0.5f);
  const auto runs = bin(map.voxels(), parked);
  const auto scanOnce = [&](BoxId box) {
    map.addBox(box, 1, runs, false);
    map.fold(box);
  };
  scanOnce(0);
  const std::size_t once = map.ledgerBytes();
  for (BoxId box = 1; box < 200; ++box) scanOnce(box);
  EXPECT_LE(map.ledgerBytes(), 2 * once);
  map.revokeTrack(1);
  EXPECT_EQ(map.voxels().size(), 0u);
}

TEST(RevocableMap, LongParkingOverflowsNothing) {
  RevocableMap map(MappingOptions{}, {0, 0, 0});
  const std::vector<VoxelRun> wall = {test::voxelRun(voxelKey(0, 0, 0), 1, 10, 20, 30, 40)};
  const std::uint32_t most = 15u * 65535u;
  const std::vector<VoxelRun> car(
      3, test::voxelRun(voxelKey(0, 0, 0), 15, most, most, most, 15u << 16));
  map.addPermanent(wall);
  const std::vector<MapPoint> before = map.voxels().points();
  for (BoxId box = 0; box < 36000; ++box) {
    map.addBox(box, 1, car, false);
    map.fold(box);
  }
  EXPECT_NEAR(map.voxels().points().at(0).x, 0.1 * 65535 / 65536, 1e-6);
  map.revokeTrack(1);
  EXPECT_TRUE(test::same(map.voxels().points(), before));
}

TEST(RevocableMap, FoldedLedgersOfGrowingObjectsComeOutWhole) {
  std::mt19937 random(2);
  RevocableMap map(MappingOptions{}, {0, 0, 0});
  for (BoxId box = 0; box < 60; ++box) {
    map.addBox(box, 1, bin(map.voxels(), RandomReturns(random, 100, 0.05f * float(box + 1))),
               false);
    map.fold(box);
  }
  EXPECT_GT(map.voxels().size(), 1000u);
  map.revokeTrack(1);
  EXPECT_EQ(map.voxels().size(), 0u);
}

TEST(RevocableMap, NeedsVoxels) {
  MappingOptions options;
  options.voxelSize = 0.0;
  EXPECT_THROW(RevocableMap(options, {0, 0, 0}), UserError);
}

}  // namespace
}  // namespace toss
