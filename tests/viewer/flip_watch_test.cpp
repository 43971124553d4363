// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "FlipWatch.h"

namespace toss::test {
namespace {

ScanLabels scanAt(double time, const std::vector<std::pair<TrackId, bool>>& traces) {
  ScanLabels labels;
  labels.time = time;
  for (const auto& [id, moving] : traces) {
    TrackSample sample;
    sample.track = id;
    sample.moving = moving;
    sample.updated = true;
    sample.box.center = {time, 0.0, 0.0};
    labels.tracks.push_back(sample);
  }
  return labels;
}

TEST(FlipWatch, ShowsAChangedVerdictForASecond) {
  FlipWatch watch;
  EXPECT_FALSE(watch.update(scanAt(0.0, {{7, false}}))[0].flipped);
  EXPECT_TRUE(watch.update(scanAt(0.1, {{7, true}}))[0].flipped);
  EXPECT_TRUE(watch.update(scanAt(1.0, {{7, true}}))[0].flipped);
  EXPECT_FALSE(watch.update(scanAt(1.2, {{7, true}}))[0].flipped);
  EXPECT_EQ(watch.flips(), 1u);
  EXPECT_TRUE(watch.update(scanAt(1.3, {{7, false}}))[0].flipped);
  EXPECT_EQ(watch.flips(), 2u);
}

TEST(FlipWatch, DoesNotCallANewTraceChanged) {
  FlipWatch watch;
  EXPECT_FALSE(watch.update(scanAt(0.0, {{3, true}}))[0].flipped);
  EXPECT_EQ(watch.flips(), 0u);
}

TEST(FlipWatch, PutsMoversFirstAndKeepsTheirWay) {
  FlipWatch watch;
  watch.update(scanAt(0.0, {{1, false}, {2, true}}));
  const auto traces = watch.update(scanAt(0.1, {{1, false}, {2, true}}));
  ASSERT_EQ(traces.size(), 2u);
  EXPECT_EQ(traces[0].sample.track, 2u);
  EXPECT_EQ(traces[0].path.size(), 2u);
  EXPECT_EQ(traces[0].path[1].x(), 0.1);
}

TEST(FlipWatch, LeavesOutWhatWasNotSeen) {
  FlipWatch watch;
  ScanLabels labels = scanAt(0.0, {{1, true}});
  labels.tracks[0].updated = false;
  EXPECT_TRUE(watch.update(labels).empty());
}

}  // namespace
}  // namespace toss::test
