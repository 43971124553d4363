// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "HindsightClaims.h"

namespace toss {
namespace {

constexpr TrackId kWalker = 7;
constexpr double kPeriod = 0.1;
constexpr std::size_t kBirth = 4, kScans = 16;
/// Owners of the returns.
constexpr ScanRecord::OwnerIndex kNobody = 0, kStanding = 1, kMoving = 2;

/// What the walker did when it was seen.
enum class Seen { Standing, Moving, Walking, Missed };

struct Case {
  double speed = 1.0;
  Seen seen = Seen::Standing;
  double voxelSize = 0.1;
  MotionClass motion = MotionClass::Strong;
  /// Scans that saw it so far, and cells of it that were looked at and seen through.
  int sightings = 5, cells = 0, free = 0;
  DecisionOptions options;
};

/// A walker who comes along x and is first seen in scan kBirth, at (10, 3, 0), and every scan
/// since.
Box walkerAt(std::size_t scan, double speed) {
  Box box;
  const double seconds = kPeriod * (static_cast<double>(scan) - static_cast<double>(kBirth));
  box.center = {10.0 + speed * seconds, 3.0, 0.0};
  box.length = 0.4, box.width = 0.6, box.height = 1.8, box.yaw = 0.3;
  return box;
}

/// Returns of all owners and classes on a lattice around the walker's way.
void addReturns(ScanRecord& record) {
  record.owners.resize(3);
  record.owners[kStanding].instance = record.owners[kMoving].instance = true;
  const auto add = [&](double x, double y, double z) {
    const std::size_t n = record.owner.size();
    const auto owner = static_cast<ScanRecord::OwnerIndex>(n % 3);
    const bool ground = owner == kNobody && n % 2 == 0;
    record.owner.push_back(owner);
    record.pointClass.push_back(owner != kNobody ? PointClass::Instance
                                : ground         ? PointClass::Ground
                                                 : PointClass::Unclustered);
    const Eigen::Vector3d level = Eigen::Vector3d(x, y, z) - record.sensorPosition;
    record.level.x.push_back(static_cast<float>(level.x()));
    record.level.y.push_back(static_cast<float>(level.y()));
    record.level.z.push_back(static_cast<float>(level.z()));
  };
  for (double x = 8.0; x < 11.0; x += 0.057)
    for (double y = 2.0; y < 4.0; y += 0.059)
      for (const double z : {-2.5, -1.0, 0.0, 1.0, 1.2}) add(x, y, z);
}

std::deque<ScanRecord> recordsOf(const Case& given) {
  std::deque<ScanRecord> records(kScans);
  for (std::size_t s = 0; s < kScans; ++s) {
    ScanRecord& record = records[s];
    record.scan = s;
    record.time = 100.0 + kPeriod * static_cast<double>(s);
    record.sensorPosition = {0.5 * static_cast<double>(s), -1.0, 0.4};
    record.firstNewTrack = s <= kBirth ? kWalker : kWalker + 1;
    if (s >= kBirth) {
      TrackSample sample;
      sample.track = kWalker;
      sample.box = walkerAt(s, given.speed);
      sample.moving = given.seen == Seen::Moving;
      sample.updated = given.seen != Seen::Missed;
      if (given.seen == Seen::Walking || given.seen == Seen::Missed) sample.velocity.x() = 1.0;
      record.tracks.push_back(sample);
    }
    addReturns(record);
  }
  return records;
}

TraceBook bookOf(const Case& given, bool awaitsEvidence) {
  TraceBook traces(given.options, awaitsEvidence);
  traces.setMotion(kWalker, given.motion);
  for (int i = 0; i < given.sightings; ++i) traces.addSighting(kWalker);
  FreeSpaceSum evidence;
  evidence.cells = given.cells, evidence.free = given.free, evidence.hit = given.cells - given.free;
  if (given.cells > 0) traces.addFinal(kWalker, evidence);
  return traces;
}

/// Adds the claims on a scan; `moving` as they leave it.
ScanRecord claimedOf(const Case& given, std::size_t scan, std::vector<bool>& moving) {
  std::deque<ScanRecord> records = recordsOf(given);
  const TraceBook traces = bookOf(given, false);
  MappingOptions mapping;
  mapping.voxelSize = given.voxelSize;
  HindsightClaims claims(given.options, mapping, traces);
  moving = {false, false, true};
  claims.add(records, scan, true, moving);
  return records[scan];
}

/// By definition: no ground unless `ground`, nothing that moves anyway, and what lies in the box
/// where the walker must have been, grown to its sides and top and a metre down.
bool mustBeClaimed(const Case& given, std::size_t scan, std::size_t point, const ScanRecord& before,
                   bool ground) {
  const Box box = walkerAt(scan, given.speed);
  const Eigen::Vector3d at =
      before.sensorPosition +
      Eigen::Vector3f(before.level.x[point], before.level.y[point], before.level.z[point])
          .cast<double>() -
      box.center;
  const double margin = given.options.residueMargin;
  const double along = std::cos(box.yaw) * at.x() + std::sin(box.yaw) * at.y();
  const double across = std::cos(box.yaw) * at.y() - std::sin(box.yaw) * at.x();
  const bool inside = std::abs(along) <= 0.5 * box.length + margin &&
                      std::abs(across) <= 0.5 * box.width + margin &&
                      at.z() <= 0.5 * box.height + margin && at.z() >= -0.5 * box.height - 1.0;
  return inside && before.owner[point] != kMoving &&
         (ground || before.pointClass[point] != PointClass::Ground);
}

void expectClaims(const Case& given, std::size_t scan, bool ground) {
  const ScanRecord before = recordsOf(given)[scan];
  std::vector<bool> moving;
  const ScanRecord after = claimedOf(given, scan, moving);
  std::vector<std::int32_t> expected;
  for (std::size_t i = 0; i < before.owner.size(); ++i) {
    const Owner& owner = after.owners[after.owner[i]];
    if (!mustBeClaimed(given, scan, i, before, ground)) {
      ASSERT_EQ(after.owner[i], before.owner[i]) << "scan " << scan << ", return " << i;
      continue;
    }
    expected.push_back(static_cast<std::int32_t>(i));
    ASSERT_EQ(owner.track, kWalker) << "scan " << scan << ", return " << i;
    EXPECT_FALSE(owner.instance);
    EXPECT_EQ(owner.host, before.owner[i] == kStanding ? kStanding : 0);
    EXPECT_TRUE(moving[after.owner[i]]);
  }
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(after.residue, expected);
  EXPECT_EQ(moving.size(), after.owners.size());
}

TEST(HindsightClaims, TakeWhatLiesWhereTheTraceMustHaveBeen) {
  // Before it was seen, and when it was.
  for (const std::size_t scan : {std::size_t{0}, std::size_t{2}, kBirth, kBirth + 3})
    expectClaims({}, scan, false);
}

TEST(HindsightClaims, TakeGroundOfWhatSeemedToMove) {
  Case given;
  for (const Seen seen : {Seen::Moving, Seen::Walking}) {
    given.seen = seen;
    expectClaims(given, kBirth + 1, true);
    expectClaims(given, kBirth - 1, false);
  }
  given.seen = Seen::Missed;
  expectClaims(given, kBirth + 1, false);
}

TEST(HindsightClaims, TakeNoGroundWithoutVoxels) {
  Case given;
  given.seen = Seen::Moving;
  given.voxelSize = 0.0;
  expectClaims(given, kBirth + 1, false);
}

TEST(HindsightClaims, AreNotMadeOfWhatStandsOrCameTooLate) {
  std::vector<bool> moving;
  Case standing;
  standing.motion = MotionClass::Static;
  EXPECT_TRUE(claimedOf(standing, kBirth + 1, moving).residue.empty());
  Case still;
  still.speed = 0.0;
  EXPECT_TRUE(claimedOf(still, 1, moving).residue.empty());
  Case late;
  late.options.hindsightTime = 0.2;
  EXPECT_TRUE(claimedOf(late, kBirth - 3, moving).residue.empty());
  EXPECT_FALSE(claimedOf(late, kBirth - 2, moving).residue.empty());
  Case off;
  off.options.claims = false;
  EXPECT_TRUE(claimedOf(off, kBirth + 1, moving).residue.empty());
}

TEST(HindsightClaims, AreMadeByWhatIsWellKnown) {
  const auto claims = [](int sightings, int cells, int free) {
    Case given;
    given.sightings = sightings, given.cells = cells, given.free = free;
    std::vector<bool> moving;
    const auto at = [&](std::size_t scan) { return claimedOf(given, scan, moving).residue.size(); };
    EXPECT_EQ(at(kBirth - 1) > 0, at(kBirth + 1) > 0);
    return at(kBirth + 1) > 0;
  };
  EXPECT_FALSE(claims(4, 0, 0));
  EXPECT_TRUE(claims(5, 0, 0));
  EXPECT_FALSE(claims(2, 10, 6));
  EXPECT_TRUE(claims(2, 10, 7));
  EXPECT_FALSE(claims(2, 1, 1)) << "one cell is no evidence";
  EXPECT_TRUE(claims(5, 10, 4));
}

TEST(HindsightClaims, MoveOnlyWhenTheirTraceIsKnownTo) {
  Case given;
  given.motion = MotionClass::Doubtful;
  std::deque<ScanRecord> records = recordsOf(given);
  const DecisionOptions options;
  const TraceBook traces = bookOf(given, true);
  std::vector<bool> moving{false, false, true};
  HindsightClaims(options, MappingOptions(), traces).add(records, 2, false, moving);
  EXPECT_FALSE(records[2].residue.empty());
  for (std::size_t o = 3; o < moving.size(); ++o) EXPECT_FALSE(moving[o]);
}

}  // namespace
}  // namespace toss
