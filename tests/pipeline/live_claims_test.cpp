// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "LiveClaims.h"

namespace toss::test {
namespace {

constexpr TrackId kWalker = 3, kParked = 4;

/// Two boxes of a metre at x = 0 and x = 10, and in each of them a return of every kind; one more
/// lone return far from both.
ScanRecord recordOfTwo() {
  ScanRecord record;
  record.owners.resize(2);
  record.owners[1].instance = true;
  for (const auto& [track, x] : {std::pair{kWalker, 0.0f}, std::pair{kParked, 10.0f}}) {
    TrackSample sample;
    sample.track = track;
    sample.box.center = {x, 0.0, 0.0};
    sample.box.length = sample.box.width = sample.box.height = 1.0;
    record.tracks.push_back(sample);
  }
  const auto add = [&](float x, PointClass pointClass) {
    record.level.x.push_back(x), record.level.y.push_back(0.1f), record.level.z.push_back(0.2f);
    record.pointClass.push_back(pointClass);
    record.owner.push_back(pointClass == PointClass::Instance ? 1 : 0);
  };
  for (const float x : {0.0f, 10.0f})
    for (const PointClass each :
         {PointClass::Unclustered, PointClass::Instance, PointClass::Ground})
      add(x, each);
  add(5.0f, PointClass::Unclustered);
  return record;
}

ScanLabels labelsOf(const DecisionOptions& options, const std::vector<bool>& moving) {
  TraceBook traces(options, true);
  traces.setMotion(kWalker, MotionClass::Strong);
  traces.setMotion(kParked, MotionClass::Static);
  const ScanRecord record = recordOfTwo();
  ScanLabels labels;
  labels.state.assign(record.owner.size(), PointState::Static);
  labels.track.assign(record.owner.size(), 9);
  LiveClaims(options, traces).add(record, moving, labels);
  return labels;
}

TEST(LiveClaims, AreOfMovingTracesAndOfNoGround) {
  const ScanLabels labels = labelsOf({}, {false, false});
  EXPECT_EQ(labels.track, (std::vector<std::uint32_t>{kWalker, kWalker, 9, 9, 9, 9, 9}));
  for (std::size_t i = 0; i < labels.state.size(); ++i)
    EXPECT_EQ(labels.state[i], i < 2 ? PointState::Moving : PointState::Static) << i;
}

TEST(LiveClaims, LeaveWhatMovesAnyway) {
  EXPECT_EQ(labelsOf({}, {false, true}).track,
            (std::vector<std::uint32_t>{kWalker, 9, 9, 9, 9, 9, 9}));
}

TEST(LiveClaims, AreNotMadeWhereNoneAreWanted) {
  DecisionOptions options;
  options.claims = false;
  EXPECT_EQ(labelsOf(options, {false, false}).track, std::vector<std::uint32_t>(7, 9));
}

}  // namespace
}  // namespace toss::test
