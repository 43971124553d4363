// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>

#include <algorithm>
#include <deque>

#include "RandomReturns.h"

namespace toss {
namespace {

using test::RandomReturns;

/// A map beside a list of what its calls have put in and whether that is still static.
class Twin {
 public:
  Twin(const MappingOptions& options, unsigned seed)
      : options_(options), map_(makeStaticMap(options, {0, 0, 0})), random_(seed) {}

  void step() {
    const auto roll = random_() % 20;
    if (roll < 4) return enter(Kind::Permanent, false);
    if (roll < 9) return enter(Kind::Box, random_() % 2 == 0);
    if (roll < 10) return enter(Kind::Folded, false);
    if (roll == 18) return endTrack(true);
    if (roll == 19) return endTrack(false);
    touchBox(roll);
  }
  void finish() { map_->finish(); }

  const StaticMap& map() const { return *map_; }
  /// A map made of what is static now alone, in an order that `seed` shuffles; 0 = as it came.
  std::vector<MapPoint> fromScratch(unsigned seed) const {
    std::vector<const Entry*> order;
    for (const Entry& entry : entries_) order.push_back(&entry);
    if (seed != 0) std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    const auto map = makeStaticMap(options_, {0, 0, 0});
    for (const Entry* entry : order) {
      if (entry->isStatic) map->addPermanent(entry->returns.scan(), entry->returns.all);
    }
    return map->points();
  }

 private:
  enum class Kind { Permanent, Box, Folded };
  struct Entry {
    Kind kind;
    TrackId track;
    bool isStatic;
    RandomReturns returns;
  };

  void enter(Kind kind, bool dynamic) {
    const TrackId track = random_() % 5;
    entries_.push_back({kind, track, !dynamic, RandomReturns(random_, random_() % 60, 0.6f)});
    Entry& entry = entries_.back();
    const ScanReturns scan = entry.returns.scan();
    if (kind == Kind::Permanent) map_->addPermanent(scan, entry.returns.all);
    if (kind == Kind::Folded) map_->addToTrack(track, scan, entry.returns.all);
    if (kind == Kind::Box)
      map_->addBox(entries_.size() - 1, track, scan, entry.returns.all, dynamic);
    if (kind == Kind::Folded && track == 0) entry.kind = Kind::Permanent;
  }

  void touchBox(std::uint_fast32_t roll) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (entries_[i].kind == Kind::Box) open.push_back(i);
    }
    if (open.empty()) return;
    const std::size_t box = open[random_() % open.size()];
    Entry& entry = entries_[box];
    if (roll < 15) {
      entry.isStatic = !entry.isStatic;
      map_->setDynamic(box, !entry.isStatic);
    } else if (roll < 17) {
      map_->fold(box);
      entry.kind = entry.isStatic && entry.track != 0 ? Kind::Folded : Kind::Permanent;
    } else {
      map_->settleBox(box);
      entry.kind = Kind::Permanent;
    }
  }

  void endTrack(bool revoke) {
    const TrackId track = 1 + random_() % 5;
    for (Entry& entry : entries_) {
      if (entry.kind != Kind::Folded || entry.track != track) continue;
      if (revoke) entry.isStatic = false;
      entry.kind = Kind::Permanent;
    }
    revoke ? map_->revokeTrack(track) : map_->settleTrack(track);
  }

  MappingOptions options_;
  std::unique_ptr<StaticMap> map_;
  std::mt19937 random_;
  std::vector<Entry> entries_;
};

class StaticMaps : public testing::TestWithParam<double> {
 protected:
  MappingOptions options() const {
    MappingOptions result;
    result.voxelSize = GetParam();
    result.cap = 5;
    return result;
  }
};

TEST_P(StaticMaps, PointsEqualThoseOfAMapFromThePresentLabels) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Twin twin(options(), seed);
    for (int i = 0; i < 400; ++i) {
      twin.step();
      if (i % 40 != 0) continue;
      ASSERT_TRUE(test::same(twin.map().points(), twin.fromScratch(0))) << seed << " " << i;
      ASSERT_EQ(twin.map().size(), twin.map().points().size());
    }
    const std::vector<MapPoint> before = twin.map().points();
    EXPECT_FALSE(before.empty());
    twin.finish();
    EXPECT_TRUE(test::same(twin.map().points(), before));
  }
}

TEST_P(StaticMaps, OrderOfEntryDoesNotShow) {
  Twin twin(options(), 77);
  for (int i = 0; i < 300; ++i) twin.step();
  const auto byPlace = [](const MapPoint& a, const MapPoint& b) {
    return std::tie(a.x, a.y, a.z, a.intensity) < std::tie(b.x, b.y, b.z, b.intensity);
  };
  std::vector<MapPoint> points = twin.map().points(), shuffled = twin.fromScratch(5);
  if (GetParam() == 0.0) {
    std::sort(points.begin(), points.end(), byPlace);
    std::sort(shuffled.begin(), shuffled.end(), byPlace);
  }
  EXPECT_TRUE(test::same(points, shuffled));
}

TEST_P(StaticMaps, DynamicReturnsLeaveStaticOnesOfTheSameVoxelAlone) {
  std::mt19937 random(9);
  const RandomReturns wall(random, 50, 0.05f), mover(random, 50, 0.05f);
  const auto map = makeStaticMap(options(), {-1, -1, -1});
  map->addPermanent(wall.scan(), wall.all);
  const std::vector<MapPoint> before = map->points();
  map->addBox(1, 7, mover.scan(), mover.all, false);
  EXPECT_FALSE(test::same(map->points(), before));
  map->setDynamic(1, true);
  EXPECT_TRUE(test::same(map->points(), before));
}

TEST_P(StaticMaps, WholeScansEqualTheirParts) {
  std::mt19937 random(13);
  constexpr std::int32_t kOwners = 9, kWithoutReturns = 4;
  const auto whole = makeStaticMap(options(), {0, 0, 0}),
             parts = makeStaticMap(options(), {0, 0, 0});
  for (BoxId firstBox = 0; firstBox < 100; firstBox += kOwners) {
    const RandomReturns returns(random, 2000, 3.0f);
    std::vector<std::int32_t> owner(returns.all.size());
    std::vector<bool> dynamic(kOwners, false);
    std::vector<std::vector<std::int32_t>> of(kOwners);
    for (int k = 1; k < kOwners; ++k) dynamic[static_cast<std::size_t>(k)] = random() % 2 == 0;
    for (std::size_t i = 0; i < owner.size(); ++i) {
      owner[i] = static_cast<std::int32_t>(random() % (kOwners + 1)) - 1;
      if (owner[i] == kWithoutReturns) owner[i] = 0;
      if (owner[i] >= 0) of[static_cast<std::size_t>(owner[i])].push_back(returns.all[i]);
    }
    whole->addScan(returns.scan(), owner, dynamic, firstBox);
    parts->addPermanent(returns.scan(), of[0]);
    for (std::size_t k = 1; k < kOwners; ++k)
      if (k != kWithoutReturns) parts->addBox(firstBox + k, 0, returns.scan(), of[k], dynamic[k]);
  }
  EXPECT_TRUE(test::same(whole->points(), parts->points()));
  EXPECT_THROW(whole->setDynamic(kWithoutReturns, true), std::logic_error);
  for (BoxId box : {1, 2, 3, 5, 6, 7, 8})
    for (StaticMap* map : {whole.get(), parts.get()}) map->setDynamic(box, box % 2 == 0);
  EXPECT_TRUE(test::same(whole->points(), parts->points()));
}

TEST_P(StaticMaps, DecidedScansEqualThoseThatAreSettled) {
  std::mt19937 random(14);
  constexpr std::int32_t kOwners = 7, kMover = 3;
  const auto decided = makeStaticMap(options(), {0, 0, 0}),
             settled = makeStaticMap(options(), {0, 0, 0});
  std::vector<bool> dynamic(kOwners, false);
  dynamic[kMover] = true;
  std::deque<RandomReturns> scans;
  std::deque<std::vector<std::int32_t>> owners;
  for (BoxId firstBox = 0; firstBox < 70; firstBox += kOwners) {
    // Dense, so that the limit of what an owner may add to a voxel shows.
    const RandomReturns& returns = scans.emplace_back(random, 2000, 0.5f);
    std::vector<std::int32_t>& owner = owners.emplace_back(returns.all.size());
    for (std::int32_t& each : owner) each = static_cast<std::int32_t>(random() % (kOwners + 1)) - 1;
    settled->addScan(returns.scan(), owner, dynamic, firstBox);
    for (BoxId k = 1; k < kOwners; ++k) settled->settleBox(firstBox + k);
    std::replace(owner.begin(), owner.end(), kMover, -1);
  }
  decided->addDecided(scans.size(), [&](std::size_t i) {
    return StaticMap::DecidedScan{scans[i].scan(), owners[i]};
  });
  EXPECT_EQ(decided->ledgerBytes(), makeStaticMap(options(), {0, 0, 0})->ledgerBytes());
  EXPECT_TRUE(test::same(decided->points(), settled->points()));
}

TEST_P(StaticMaps, BoxesThatAreNotOpenAreLogicErrors) {
  std::mt19937 random(10);
  const RandomReturns returns(random, 5, 1.0f);
  const auto map = makeStaticMap(options(), {0, 0, 0});
  map->addBox(3, 1, returns.scan(), returns.all, false);
  EXPECT_THROW(map->addBox(3, 1, returns.scan(), returns.all, false), std::logic_error);
  EXPECT_GT(map->ledgerBytes(), 0u);
  map->fold(3);
  EXPECT_THROW(map->setDynamic(3, true), std::logic_error);
  EXPECT_THROW(map->settleBox(4), std::logic_error);
  EXPECT_NO_THROW(map->revokeTrack(99));
  EXPECT_NO_THROW(map->settleTrack(99));
  EXPECT_GT(map->size(), 0u);
  map->revokeTrack(1);
  EXPECT_EQ(map->size(), 0u);
}

TEST_P(StaticMaps, BadInputIsCountedOrTheUsersError) {
  std::mt19937 random(11);
  RandomReturns returns(random, 10, 1.0f);
  const auto map = makeStaticMap(options(), {0, 0, 0});
  returns.level.y[4] = std::nanf("");
  returns.intensity.clear();
  map->addPermanent(returns.scan(), returns.all);
  EXPECT_EQ(map->leftOut(), 1u);
  for (const MapPoint& point : map->points()) EXPECT_EQ(point.intensity, 0.0f);
  returns.sensorPosition.z() = std::nan("");
  EXPECT_THROW(map->addPermanent(returns.scan(), returns.all), UserError);
}

INSTANTIATE_TEST_SUITE_P(VoxelSizes, StaticMaps, testing::Values(0.0, 0.1, 0.25),
                         [](const auto& parameter) {
                           return "Size" + std::to_string(static_cast<int>(100 * parameter.param));
                         });

TEST(EveryReturn, KeepsReturnsInTheirOrderAndPlace) {
  std::mt19937 random(12);
  RandomReturns returns(random, 100, 30.0f);
  returns.sensorPosition = {100.0, -50.0, 3.0};
  MappingOptions options;
  options.voxelSize = 0.0;
  const auto map = makeStaticMap(options, {0, 0, 0});
  map->addPermanent(returns.scan(), returns.all);
  const std::vector<MapPoint> points = map->points();
  ASSERT_EQ(points.size(), 100u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_FLOAT_EQ(points[i].x, returns.level.x[i] + 100.0f);
    EXPECT_FLOAT_EQ(points[i].y, returns.level.y[i] - 50.0f);
    EXPECT_EQ(points[i].intensity, returns.intensity[i]);
  }
}

TEST(MappingOptions, RangesAreChecked) {
  MappingOptions options;
  options.voxelSize = -0.1;
  EXPECT_THROW(makeStaticMap(options, {0, 0, 0}), UserError);
  options.voxelSize = 0.1;
  options.cap = 0;
  EXPECT_THROW(makeStaticMap(options, {0, 0, 0}), UserError);
  options.set("far_points", "drop");
  EXPECT_EQ(options.farPoints, FarPoints::Drop);
}

}  // namespace
}  // namespace toss
