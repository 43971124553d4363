// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ScanLabeling.h"

namespace toss::test {
namespace {

constexpr TrackId kHostTrack = 3, kCutter = 7;

/// One return each of: nobody, an instance, what a trace cuts out of it, residue beside it, residue
/// on the ground.
ScanRecord recordOfAll() {
  ScanRecord record;
  record.owners.resize(5);
  record.owners[1].instance = true;
  record.owners[1].track = kHostTrack;
  for (std::size_t o = 2; o < 5; ++o) record.owners[o].track = kCutter;
  record.owners[2].host = record.owners[3].host = 1;
  record.owners[3].residue = record.owners[4].residue = true;
  record.owner = {0, 1, 2, 3, 4};
  record.pointClass.assign(5, PointClass::Instance);
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
  const ScanLabels labels = labelsOf(recordOfAll(), std::vector<bool>(5, false));
  EXPECT_EQ(movingOf(labels), std::vector<bool>(5, false));
  EXPECT_EQ(labels.track, (std::vector<std::uint32_t>{0, kHostTrack, kHostTrack, kHostTrack, 0}));
}

TEST(ScanLabeling, WhatATraceCutsMovesWithItAndResidueWaits) {
  const ScanLabels labels = labelsOf(recordOfAll(), {false, false, true, true, true});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, false, true, false, false}));
  EXPECT_EQ(labels.track, (std::vector<std::uint32_t>{0, kHostTrack, kCutter, kHostTrack, 0}));
}

TEST(ScanLabeling, WhatIsCutMovesWithItsInstanceToo) {
  const ScanLabels labels = labelsOf(recordOfAll(), {false, true, true, true, false});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, true, true, true, false}));
}

TEST(ScanLabeling, ReleasedResidueMovesWithItsTrace) {
  ScanRecord record = recordOfAll();
  record.loneMovers = {3, 4};
  const ScanLabels labels = labelsOf(record, {false, false, true, true, true});
  EXPECT_EQ(movingOf(labels), (std::vector<bool>{false, false, true, true, true}));
  EXPECT_EQ(labels.track[3], kCutter);
  EXPECT_EQ(labels.track[4], kCutter);
}

TEST(ScanRecord, ReturnsOfOwnersThatTwoBytesCanNotNameAreNobodys) {
  EXPECT_EQ(ScanRecord::ownerIndex(0), 0);
  EXPECT_EQ(ScanRecord::ownerIndex(65535), 65535);
  EXPECT_EQ(ScanRecord::ownerIndex(65536), 0);
}

}  // namespace
}  // namespace toss::test
