// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "RandomReturns.h"

namespace toss {
namespace {

using test::RandomReturns;
using Index = std::array<std::int32_t, 3>;

constexpr std::uint32_t kNoCap = 65535;

struct Mean {
  int count = 0;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
};

/// Order of the points of a map.
struct ByPlace {
  bool operator()(VoxelKey a, VoxelKey b) const { return place(a) < place(b); }
  static std::pair<std::uint64_t, std::uint64_t> place(VoxelKey key) {
    return {placeInMap(cubeOf(key, kBlockBits)), placeInBlock(key)};
  }
};

/// Voxels in double precision, straight from the definition.
std::map<VoxelKey, Mean, ByPlace> bruteForce(const RandomReturns& returns, double voxelSize,
                                             const Eigen::Vector3d& origin, int cap) {
  std::map<VoxelKey, Mean, ByPlace> voxels;
  for (std::size_t i = 0; i < returns.all.size(); ++i) {
    const Eigen::Vector3d p =
        returns.sensorPosition +
        Eigen::Vector3d(returns.level.x[i], returns.level.y[i], returns.level.z[i]);
    const Eigen::Vector3d q = (p - origin) / voxelSize;
    const auto floored = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
    Mean& mean = voxels[voxelKey(floored(q.x()), floored(q.y()), floored(q.z()))];
    if (mean.count == cap) continue;
    ++mean.count;
    mean.sum += Eigen::Vector4d(p.x(), p.y(), p.z(), returns.intensity[i]);
  }
  return voxels;
}

std::vector<VoxelRun> bin(const VoxelMap& map, const RandomReturns& r, std::uint32_t cap) {
  std::vector<VoxelRun> result;
  EXPECT_EQ(
      map.bin(r.level.x, r.level.y, r.level.z, r.intensity, r.sensorPosition, r.all, cap, result),
      0u);
  return result;
}

/// Returns of each voxel.
std::map<VoxelKey, std::uint64_t> countByVoxel(const std::vector<VoxelRun>& runs) {
  std::map<VoxelKey, std::uint64_t> counts;
  for (const VoxelRun& run : runs) counts[run.key] += run.count();
  return counts;
}

void expectCentroids(const RandomReturns& returns, double voxelSize, const Eigen::Vector3d& origin,
                     std::uint32_t cap) {
  VoxelMap map(voxelSize, origin);
  const std::vector<VoxelRun> runs = bin(map, returns, cap);
  const auto counts = countByVoxel(runs);
  map.add(runs);
  const std::vector<MapPoint> points = map.points();
  const auto expected = bruteForce(returns, voxelSize, origin, static_cast<int>(cap));
  ASSERT_EQ(points.size(), expected.size());
  ASSERT_EQ(counts.size(), expected.size());
  std::size_t i = 0;
  for (const auto& [key, mean] : expected) {
    EXPECT_EQ(counts.at(key), static_cast<std::uint64_t>(mean.count));
    const Eigen::Vector4d m = mean.sum / mean.count;
    const MapPoint& p = points[i++];
    const double tolerance = voxelSize / 65536.0 + 1e-6 * m.head<3>().cwiseAbs().maxCoeff();
    EXPECT_NEAR(p.x, m.x(), tolerance);
    EXPECT_NEAR(p.y, m.y(), tolerance);
    EXPECT_NEAR(p.z, m.z(), tolerance);
    EXPECT_NEAR(p.intensity, m.w(), 1.0 / 65536.0);
  }
}

TEST(VoxelMap, CentroidsEqualBruteForceAroundTheOrigin) {
  std::mt19937 random(1);
  for (const double voxelSize : {0.1, 0.2, 0.37}) {
    expectCentroids(RandomReturns(random, 20000, 1.5f), voxelSize, {0, 0, 0}, kNoCap);
  }
}

TEST(VoxelMap, CentroidsEqualBruteForceFarFromTheMapsZero) {
  std::mt19937 random(2);
  RandomReturns returns(random, 5000, 60.0f);
  const Eigen::Vector3d origin(457000.5, 5428000.25, 110.0);
  returns.sensorPosition = origin + Eigen::Vector3d(-812.3, 390.7, -4.2);
  expectCentroids(returns, 0.1, origin, kNoCap);
}

TEST(VoxelMap, CapCountsTheFirstReturnsOfEachVoxel) {
  std::mt19937 random(3);
  expectCentroids(RandomReturns(random, 20000, 0.5f), 0.2, {0, 0, 0}, 7);
}

TEST(VoxelMap, HoldsTheVoxelsOfItsReturnsAndNoOthers) {
  std::mt19937 random(5);
  RandomReturns inside(random, 3000, 4.0f), outside(random, 3000, 4.0f);
  inside.sensorPosition = outside.sensorPosition = {1e5, -3e4, 12.34};
  VoxelMap map(0.25, inside.sensorPosition + Eigen::Vector3d(0.1, 0.2, 0.3));
  const auto runs = bin(map, inside, kNoCap);
  map.add(runs);
  const auto keyOf = [&](const RandomReturns& r, std::size_t i) {
    return map.placesOf(r.level, r.sensorPosition).of(i);
  };
  std::set<VoxelKey> expected;
  for (std::size_t i = 0; i < inside.all.size(); ++i) expected.insert(keyOf(inside, i));
  std::set<VoxelKey> binned;
  for (const VoxelRun& run : runs) binned.insert(run.key);
  EXPECT_EQ(expected, binned);
  for (int bits = 0; bits <= kBlockBits; ++bits) {
    std::set<VoxelKey> cubes;
    for (const VoxelKey key : expected) cubes.insert(cubeOf(key, bits));
    std::size_t held = 0;
    for (std::size_t i = 0; i < outside.all.size(); ++i) {
      const VoxelKey key = keyOf(outside, i);
      EXPECT_EQ(map.holds(key, bits), cubes.count(cubeOf(key, bits)) == 1);
      held += map.holds(key, bits);
    }
    EXPECT_GT(held, 0u);
    EXPECT_LT(held, outside.all.size());
  }
  map.subtract(runs);
  for (const VoxelKey key : expected) EXPECT_FALSE(map.holds(key, 0));
}

TEST(VoxelMap, TinyVoxelsOverALargeExtentAreSortedAlike) {
  std::mt19937 random(4);
  RandomReturns returns(random, 3000, 900.0f);
  returns.level.x[7] = returns.level.x[11] = returns.level.x[2000];
  returns.level.y[7] = returns.level.y[11] = returns.level.y[2000];
  returns.level.z[7] = returns.level.z[11] = returns.level.z[2000];
  expectCentroids(returns, 0.001, {0, 0, 0}, 2);
}

TEST(VoxelMap, OnlyTheGivenIndicesCount) {
  std::mt19937 random(5);
  RandomReturns returns(random, 100, 1.0f);
  returns.all = {3, 50, 99};
  VoxelMap map(0.001);
  EXPECT_EQ(bin(map, returns, kNoCap).size(), 3u);
  returns.all.clear();
  EXPECT_TRUE(bin(map, returns, kNoCap).empty());
}

TEST(VoxelMap, LeavesOutAndCountsWhatHasNoPlace) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> x = {0.5f, nan, infinity, -infinity, 1e30f, 0.5f, -200000.0f};
  const std::vector<float> zero(x.size(), 0.5f);
  const std::vector<float> intensity = {nan, 1, 1, 1, 1, -3.0f, 1};
  VoxelMap map(0.1);
  std::vector<VoxelRun> result;
  const std::vector<std::int32_t> all = {0, 1, 2, 3, 4, 5, 6};
  EXPECT_EQ(map.bin(x, zero, zero, intensity, {0, 0, 0}, all, kNoCap, result), 5u);
  const auto counts = countByVoxel(result);
  ASSERT_EQ(counts.size(), 1u);
  EXPECT_EQ(counts.begin()->second, 2u);
  for (const VoxelRun& run : result) EXPECT_EQ(run.intensity(), 0u);
  EXPECT_EQ(map.bin(x, zero, zero, {}, {0, 0, 0}, all, kNoCap, result), 5u);
}

TEST(VoxelMap, NegativeCoordinatesGoDownNotTowardsZero) {
  VoxelMap map(0.5);
  std::vector<VoxelRun> result;
  map.bin({-0.1f, 0.1f}, {-0.6f, 0.0f}, {-0.5f, 0.0f}, {}, {0, 0, 0},
          std::vector<std::int32_t>{0, 1}, kNoCap, result);
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(voxelIndex(result[0].key), (Index{-1, -2, -1}));
  EXPECT_EQ(voxelIndex(result[1].key), (Index{0, 0, 0}));
}

TEST(VoxelMap, SensorOutOfReachIsTheUsersError) {
  VoxelMap map(0.1, {10, 0, 0});
  std::vector<VoxelRun> result;
  const std::vector<std::int32_t> none;
  EXPECT_NO_THROW(map.bin({}, {}, {}, {}, {104000, 0, 0}, none, kNoCap, result));
  EXPECT_THROW(map.bin({}, {}, {}, {}, {106000, 0, 0}, none, kNoCap, result), UserError);
  EXPECT_THROW(map.bin({}, {}, {}, {}, {0, std::nan(""), 0}, none, kNoCap, result), UserError);
  for (const double size : {0.0, -1.0, std::nan("")}) EXPECT_THROW(VoxelMap{size}, UserError);
}

TEST(VoxelMap, SubtractingLeavesNoTrace) {
  std::mt19937 random(6);
  VoxelMap map(0.2), reference(0.2);
  const auto stays = bin(map, RandomReturns(random, 5000, 2.0f), kNoCap);
  const auto goes = bin(map, RandomReturns(random, 5000, 2.5f), kNoCap);
  reference.add(stays);
  map.add(goes);
  map.add(stays);
  map.subtract(goes);
  EXPECT_EQ(map.size(), reference.size());
  EXPECT_TRUE(test::same(map.points(), reference.points()));
  map.subtract(stays);
  EXPECT_EQ(map.size(), 0u);
  EXPECT_THROW(map.subtract(stays), std::logic_error);
}

TEST(VoxelMap, MinimumCountHidesThinVoxels) {
  VoxelMap map(1.0);
  map.add(std::vector{test::voxelRun(voxelKey(0, 0, 0), 1, 5, 5, 5, 0),
                      test::voxelRun(voxelKey(1, 0, 0), 3, 5, 5, 5, 0)});
  EXPECT_EQ(map.size(1), 2u);
  EXPECT_EQ(map.size(2), 1u);
  ASSERT_EQ(map.points(2).size(), 1u);
  EXPECT_GT(map.points(2)[0].x, 1.0f);
}

TEST(VoxelMap, SumsHoldMoreThanThirtyTwoBits) {
  VoxelMap map(1.0);
  constexpr std::uint64_t kCount = 15, kHalf = kCount * 32768;
  const std::vector<VoxelRun> many(
      1000, test::voxelRun(voxelKey(-1, 0, 0), kCount, kHalf, kHalf, kHalf, kCount << 32));
  for (int i = 0; i < 1000; ++i) map.add(many);
  const MapPoint p = map.points().at(0);
  EXPECT_FLOAT_EQ(p.x, -0.5f);
  EXPECT_FLOAT_EQ(p.y, 0.5f);
  EXPECT_FLOAT_EQ(p.intensity, 65536.0f);
  EXPECT_EQ(map.size(1000u * 1000u * kCount), 1u);
  EXPECT_EQ(map.size(1000u * 1000u * kCount + 1), 0u);
  for (int i = 0; i < 1000; ++i) map.subtract(many);
  EXPECT_EQ(map.size(), 0u);
}

/// Counts around those that a record holds itself, come to from either side.
TEST(VoxelMap, SumsAreTheSameWhetherTheyGrewOrShrank) {
  constexpr int kMost = 40;
  const auto runsOf = [](int i) {
    const auto n = static_cast<std::uint64_t>(i % 15 + 1);
    return std::vector{test::voxelRun(voxelKey(i % 3, 0, 0), n, 65535 * n, n, 7, n << 32),
                       test::voxelRun(voxelKey(2, 3, 1), 1, 1, 2, 3, 4)};
  };
  std::vector<std::vector<MapPoint>> grown;
  VoxelMap map(1.0);
  for (int i = 0; i < kMost; ++i) {
    grown.push_back(map.points());
    for (int times = 0; times < 9; ++times) map.add(runsOf(i));
  }
  EXPECT_EQ(map.size(256), 4u);
  for (int i = kMost - 1; i >= 0; --i) {
    for (int times = 0; times < 9; ++times) map.subtract(runsOf(i));
    EXPECT_TRUE(test::same(map.points(), grown[static_cast<std::size_t>(i)])) << i;
  }
  EXPECT_EQ(map.size(), 0u);
}

/// Every return of one voxel, and each owner on its own.
TEST(VoxelMap, CapHoldsForEachOwner) {
  constexpr std::size_t kOwners = 3;
  for (const std::uint32_t cap : {1u, 15u, 16u, 50u}) {
    const std::vector<float> same(200, 0.55f);
    std::vector<std::int32_t> owner(same.size());
    std::array<std::uint64_t, kOwners> counts{}, expected{};
    for (std::size_t i = 0; i < owner.size(); ++i) {
      owner[i] = static_cast<std::int32_t>(i % 7 < 4 ? 2 : i % 7 - 5);
      if (owner[i] >= 0) ++expected[static_cast<std::size_t>(owner[i])];
    }
    VoxelMap map(0.1);
    BinnedReturns binned;
    map.binByOwner(same, same, same, {}, {0, 0, 0}, owner, cap, binned);
    for (const auto* runs : {&binned.permanent, &binned.owned})
      for (const VoxelRun& run : *runs) counts.at(run.owner()) += run.count();
    for (std::size_t o = 0; o < kOwners; ++o)
      EXPECT_EQ(counts[o], std::min<std::uint64_t>(cap, expected[o])) << cap << " " << o;
  }
}

/// Voxels of a level plane and of a wall, as a robot that drives past them leaves them.
TEST(VoxelMap, AVoxelOfASurfaceTakesLessThanThirtyBytes) {
  VoxelMap map(0.1);
  double most = 0.0;
  for (std::int32_t x = 0; x < 1500; ++x) {
    std::vector<VoxelRun> slice;
    for (std::int32_t y = 0; y < 100; ++y)
      slice.push_back(test::voxelRun(voxelKey(x, y, 7), 1, 0, 0, 0, 0));
    for (std::int32_t z = 8; z < 60; ++z)
      slice.push_back(test::voxelRun(voxelKey(x, 99, z), 1, 0, 0, 0, 0));
    map.add(slice);
    if (x % 100 == 99) {
      most = std::max(most, static_cast<double>(map.bytes()) / static_cast<double>(map.size()));
    }
  }
  RecordProperty("most_bytes_per_voxel", std::to_string(most));
  EXPECT_LT(most, 30.0);
  EXPECT_GT(most, 16.0);
}

}  // namespace
}  // namespace toss
