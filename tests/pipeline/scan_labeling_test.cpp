// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ScanLabeling.h"

namespace toss::test {
namespace {

constexpr TrackId kHostTrack = 3, kCutter = 7;

/// One return each of: nobody, an instance, what a trace claims out of it, and on the ground.
ScanRecord recordOfAll() {
  ScanRecord record;
  record.owners.resize(2);
  record.owners[1].instance = true;
  record.owners[1].track = kHostTrack;
  record.owners.push_back(Owner::ofClaim(kCutter, 1));
  record.owners.push_back(Owner::ofClaim(kCutter, 0));
  record.owner = {0, 1, 2, 3};
  for (const TrackId track : {kHostTrack, kCutter}) {
    record.tracks.emplace_back();
    record.tracks.back().track = track;
  }
  record.pointClass.assign(4, PointClass::Instance);
  return record;
}

ScanLabels labelsOf(const ScanRecord& record, const std::vector<bool>& moving) {
  ScanLabels labels;
  labelScan(
      record, moving, [&](TrackId id) { return id == kCutter ? moving[2] : moving[1]; }, labels);
  return labels;
}

std::vector<bool> movingOf(const ScanLabels& labels) {
  std::vector<bool> moving;
  for (const PointState state : labels.state) moving.push_back(state == PointState::Moving);
  return moving;
}

TEST(ScanLabeling, NothingMovesWhereNeitherDoes) {
  const ScanLabels labels = labelsOf(recordOfAll(), std::vector<bool>(4, false));
  EXPECT_EQ(movingOf(labels), std::vector<bool>(4, false));
  EXPECT_EQ(labels.track, (std::vector<std::uint32_t>{0, kHostTrack, kHostTrack, 0}));
}

TEST(ScanLabeling, WhatATraceClaimsWaits) {
  const ScanLabels labels = labelsOf(recordOfAll(), {false, false, true, true});
  EXPECT_EQ(movingOf(labels), std::vector<bool>(4, false));
  EXPECT_EQ(labels.track, (std::vector<std::uint32_t>{0, kHostTrack, kHostTrack, 0}));
}

TEST(ScanLabeling, WhatIsClaimedMovesWithItsInstance) {
  const ScanLabels labels = labelsOf(recordOfAll(), {false, true, true, false});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, true, true, false}));
}

TEST(ScanLabeling, ReleasedResidueMovesWithItsTrace) {
  ScanRecord record = recordOfAll();
  record.loneMovers = {2, 3};
  const ScanLabels labels = labelsOf(record, {false, false, true, true});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, false, true, true}));
  EXPECT_EQ(labels.track[2], kCutter);
  EXPECT_EQ(labels.track[3], kCutter);
}

TEST(ScanLabeling, ResidueOfATraceThatWasNotSeenYetCarriesNoNumber) {
  ScanRecord record = recordOfAll();
  record.tracks.pop_back();
  record.loneMovers = {2, 3};
  const ScanLabels labels = labelsOf(record, {false, false, true, true});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, false, true, true}));
  EXPECT_EQ(labels.track[2], 0u);
  EXPECT_EQ(labels.track[3], 0u);
}

TEST(ScanRecord, ReturnsOfOwnersThatTwoBytesCanNotNameAreNobodys) {
  EXPECT_EQ(ScanRecord::ownerIndex(0), 0);
  EXPECT_EQ(ScanRecord::ownerIndex(65535), 65535);
  EXPECT_EQ(ScanRecord::ownerIndex(65536), 0);
}

}  // namespace
}  // namespace toss::test
