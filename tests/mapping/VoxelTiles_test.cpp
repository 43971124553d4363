// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/mapping/MapOffset.h>

#include <map>

#include "RandomReturns.h"

namespace toss {
namespace {

using test::RandomReturns;

struct Shelf : TileStore {
  std::map<std::uint64_t, std::vector<std::uint8_t>> tiles;
  std::size_t stored = 0, loaded = 0;

  void store(std::uint64_t tile, const std::vector<std::uint8_t>& bytes) override {
    tiles[tile] = bytes;
    ++stored;
  }
  void load(std::uint64_t tile, std::vector<std::uint8_t>& bytes) override {
    bytes = tiles.at(tile);
    ++loaded;
  }
};

MappingOptions smallTiles() {
  MappingOptions options;
  options.tileSize = 5.0;
  options.tilesKeepRadius = 12.0;
  return options;
}

/// A robot that drives out and back again along x; `see` is called with each scan.
template <typename See>
void driveOutAndBack(See&& see) {
  std::mt19937 random(1);
  for (int step = -150; step <= 150; ++step) {
    RandomReturns returns(random, 300, 4.0f);
    returns.sensorPosition = {0.5 * (150 - std::abs(step)), 0.3, -0.2};
    see(step + 150, returns);
  }
}

/// Takes a box back 80 scans after it was entered, when the robot is far away.
void drive(StaticMap& map) {
  constexpr int kLater = 80;
  driveOutAndBack([&](int number, const RandomReturns& returns) {
    const auto box = static_cast<BoxId>(number);
    std::vector<std::int32_t> owner(returns.all.size());
    for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = i % 3 == 0;
    map.addScan(returns.scan(), owner, {false, false}, 2 * box);
    if (number >= kLater) map.setDynamic(2 * (box - kLater) + 1, true);
    map.leaveBehind(returns.sensorPosition);
  });
}

TEST(VoxelTiles, HoldWhatLiesInTheStoreToo) {
  Shelf shelf;
  const auto map = makeStaticMap(smallTiles(), Eigen::Vector3d::Zero(), &shelf);
  std::vector<VoxelKey> places;
  driveOutAndBack([&](int number, const RandomReturns& returns) {
    map->addScan(returns.scan(), std::vector<std::int32_t>(returns.all.size(), 0), {false}, 0);
    if (number == 0) places.push_back(map->placesOf(returns.scan()).of(0));
    map->leaveBehind(returns.sensorPosition);
    if (number != 150) return;
    for (const VoxelKey place : places) EXPECT_TRUE(map->holds(place, 0.2));
  });
  EXPECT_GT(shelf.loaded, 0u);
  std::mt19937 random(3);
  RandomReturns nowhere(random, 1, 4.0f);
  nowhere.sensorPosition = {5000.0, 0.0, 0.0};
  EXPECT_FALSE(map->holds(map->placesOf(nowhere.scan()).of(0), 0.2));
}

TEST(VoxelTiles, LeavingBehindDoesNotShow) {
  Shelf shelf;
  const auto tiled = makeStaticMap(smallTiles(), {0, 0, 0}, &shelf);
  const auto whole = makeStaticMap(smallTiles(), {0, 0, 0});
  drive(*tiled);
  drive(*whole);
  EXPECT_GT(shelf.tiles.size(), 10u);
  EXPECT_GT(shelf.loaded, 10u);
  EXPECT_EQ(tiled->size(), whole->size());
  EXPECT_TRUE(test::same(tiled->points(), whole->points()));
}

TEST(VoxelTiles, ComeBackWithWhatACrowdedVoxelHeld) {
  Shelf shelf;
  VoxelMap map(0.1, {0, 0, 0}, 5.0, &shelf), whole(0.1);
  for (int times = 0; times < 300; ++times)
    for (VoxelMap* each : {&map, &whole})
      each->add(std::vector{test::voxelRun(voxelKey(0, 0, 0), 3, 1, 2, 3, 4),
                            test::voxelRun(voxelKey(1, 0, times % 2), 1, 1, 2, 3, 4)});
  for (int i = 0; i < 200; ++i) map.leaveBehind({1000.0, 0, 0}, 1.0);
  EXPECT_EQ(map.tilesInStore(), 1u);
  EXPECT_TRUE(test::same(map.points(), whole.points()));
  for (VoxelMap* each : {&map, &whole})
    each->add(std::vector{test::voxelRun(voxelKey(0, 0, 0), 1, 7, 7, 7, 7)});
  EXPECT_EQ(map.tilesInStore(), 0u);
  EXPECT_TRUE(test::same(map.points(), whole.points()));
}

TEST(VoxelTiles, MemoryDoesNotGrowWithTheWay) {
  Shelf shelf;
  const MappingOptions options = smallTiles();
  VoxelMap map(options.voxelSize, {0, 0, 0}, options.tileSize, &shelf);
  std::vector<std::size_t> bytes;
  std::mt19937 random(2);
  for (int step = 0; step < 1200; ++step) {
    RandomReturns returns(random, 300, 4.0f);
    returns.sensorPosition.x() = 0.5 * step;
    std::vector<VoxelRun> runs;
    map.bin(returns.level.x, returns.level.y, returns.level.z, {}, returns.sensorPosition,
            returns.all, 50, runs);
    map.add(runs);
    map.leaveBehind(returns.sensorPosition, options.tilesKeepRadius);
    if (step % 300 == 299) bytes.push_back(map.bytes());
  }
  EXPECT_LT(bytes[3], bytes[1] + bytes[1] / 4);
  EXPECT_GT(map.tilesInStore(), 50u);
  EXPECT_GT(map.size(), 4 * 60000u);
}

TEST(VoxelTiles, WithoutAStoreNothingLeaves) {
  VoxelMap map(0.1, {0, 0, 0}, 5.0, nullptr);
  map.add(std::vector{test::voxelRun(voxelKey(0, 0, 0), 1, 0, 0, 0, 0)});
  for (int i = 0; i < 200; ++i) map.leaveBehind({1000.0, 0, 0}, 1.0);
  EXPECT_EQ(map.tilesInStore(), 0u);
  EXPECT_EQ(map.points().size(), 1u);
}

TEST(MapOffset, IsZeroNearTheOriginAndWholeKilometresFarFromIt) {
  EXPECT_TRUE(mapOffset({99999.0, -5000.0, 100.0}).isZero(0.0));
  EXPECT_EQ(mapOffset({457234.5, 5428499.0, 110.0}), Eigen::Vector3d(457000.0, 5428000.0, 0.0));
}

TEST(MapOffset, KeepsFarMapsAsExactAsNearOnes) {
  const Eigen::Vector3d far(457234.5, 5428499.0, 110.0);
  for (const double voxelSize : {0.0, 0.1}) {
    MappingOptions options;
    options.voxelSize = voxelSize;
    std::mt19937 random(3);
    RandomReturns returns(random, 1, 4.0f);
    returns.sensorPosition = far;
    const auto map = makeStaticMap(options, far);
    map->addPermanent(returns.scan(), returns.all);
    const MapPoint p = map->points(mapOffset(far)).at(0);
    const double tolerance = 1e-4;
    EXPECT_NEAR(p.x, 234.5 + static_cast<double>(returns.level.x[0]), tolerance);
    EXPECT_NEAR(p.y, 499.0 + static_cast<double>(returns.level.y[0]), tolerance);
  }
}

}  // namespace
}  // namespace toss
