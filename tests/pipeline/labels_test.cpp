// SPDX-License-Identifier: BSD-3-Clause
#include "SimulatedScans.h"

namespace toss::test {
namespace {

bool isMovingClass(std::uint32_t label) {
  return (label & 0xFFFFu) >= 252 && (label & 0xFFFFu) <= 259;
}

/// Moving returns that were called so, by the simulator's truth, and those called so in all.
struct Found {
  double recall = 0.0, precision = 0.0;
};

Found foundIn(const std::vector<SimulatedScan>& scans, const std::vector<ScanLabels>& labels) {
  double moving = 0, called = 0, both = 0;
  for (std::size_t s = 0; s < scans.size(); ++s)
    for (std::size_t i = 0; i < scans[s].labels.size(); ++i) {
      const bool truth = isMovingClass(scans[s].labels[i]);
      const bool answer = labels[s].state[i] == PointState::Moving;
      moving += truth, called += answer, both += truth && answer;
    }
  return {both / moving, both / called};
}

TEST(PipelineLabels, AreAlignedWithTheReturnsOfEachScanInOrder) {
  const auto scans = crossingScans(12);
  const PipelineRun run = runOf(scans);
  ASSERT_EQ(run.live.size(), scans.size());
  ASSERT_EQ(run.settled.size(), scans.size());
  for (std::size_t s = 0; s < scans.size(); ++s)
    for (const ScanLabels* labels : {&run.live[s], &run.settled[s]}) {
      EXPECT_EQ(labels->scan, scans[s].scan.index);
      EXPECT_EQ(labels->time, scans[s].scan.time);
      EXPECT_EQ(labels->state.size(), scans[s].scan.points.size());
      EXPECT_EQ(labels->track.size(), scans[s].scan.points.size());
      EXPECT_TRUE(std::is_sorted(labels->tracks.begin(), labels->tracks.end(),
                                 [](const auto& a, const auto& b) { return a.track < b.track; }));
    }
}

TEST(PipelineLabels, FindWhatMoves) {
  const auto scans = crossingScans(30);
  const PipelineRun run = runOf(scans);
  const Found final = foundIn(scans, run.settled), live = foundIn(scans, run.live);
  EXPECT_GT(final.recall, 0.95);
  EXPECT_GT(final.precision, 0.95);
  EXPECT_GT(live.recall, 0.5);
  EXPECT_GT(live.precision, 0.9);
  EXPECT_GE(final.recall, live.recall);
}

TEST(PipelineLabels, MovingReturnsOfATraceCarryItsNumber) {
  const auto scans = crossingScans(20);
  std::size_t traced = 0, moving = 0;
  for (const ScanLabels& labels : runOf(scans).settled)
    for (std::size_t i = 0; i < labels.state.size(); ++i) {
      if (labels.state[i] == PointState::Invalid) {
        EXPECT_EQ(labels.track[i], 0u);
      }
      if (labels.state[i] != PointState::Moving) continue;
      ++moving;
      if (labels.track[i] == 0) continue;
      ++traced;
      EXPECT_TRUE(std::any_of(labels.tracks.begin(), labels.tracks.end(),
                              [&](const auto& sample) { return sample.track == labels.track[i]; }));
    }
  EXPECT_GT(traced, moving * 9 / 10);
}

TEST(PipelineLabels, SettleInOrderOnceTheHorizonHasPassed) {
  PipelineOptions options;
  options.voting.horizon = 2.5;
  options.voting.tauS = 1.0;
  options.visibility.offsets = "0.5 1";
  PipelineRun run(options);
  const auto scans = crossingScans(40);
  for (std::size_t s = 0; s < scans.size(); ++s) {
    run.process(scans[s].scan);
    for (const ScanLabels& labels : run.settled)
      EXPECT_GT(scans[s].scan.time - labels.time, 0.5 * options.voting.horizon);
  }
  // 40 scans at 10 Hz: the first 14 are more than 2.5 s older than the last.
  EXPECT_EQ(run.settled.size(), 14u);
  run.finish();
  ASSERT_EQ(run.settled.size(), scans.size());
  for (std::size_t s = 0; s < scans.size(); ++s) EXPECT_EQ(run.settled[s].scan, s);
}

TEST(PipelineLabels, NothingSettlesBeforeTheEndWithoutAHorizon) {
  PipelineOptions options;
  options.voting.horizon = 0.0;
  PipelineRun run(options);
  const auto scans = crossingScans(15);
  for (const SimulatedScan& each : scans) run.process(each.scan);
  EXPECT_TRUE(run.settled.empty());
  run.finish();
  EXPECT_EQ(run.settled.size(), scans.size());
  // The log is shorter than the default horizon, which therefore changes nothing.
  const PipelineRun bounded = runOf(scans);
  expectSameLabels(run.settled, bounded.settled);
  EXPECT_TRUE(sameMap(run.pipeline->staticMap(), bounded.pipeline->staticMap()));
}

TEST(PipelineLabels, AreTheSameWhenTheLogIsRunAgain) {
  const auto scans = crossingScans(15);
  const PipelineRun first = runOf(scans), second = runOf(scans);
  expectSameLabels(first.live, second.live);
  expectSameLabels(first.settled, second.settled);
}

TEST(PipelineLabels, AreFinallyTheSameWithoutLiveOnes) {
  const auto scans = crossingScans(30);
  const PipelineRun both = runOf(scans);
  PipelineRun finalOnly;
  finalOnly.pipeline->skipLiveLabels();
  for (const SimulatedScan& each : scans) finalOnly.process(each.scan);
  finalOnly.finish();
  for (const ScanLabels& labels : finalOnly.live) EXPECT_TRUE(labels.state.empty());
  expectSameLabels(both.settled, finalOnly.settled);
  EXPECT_TRUE(sameMap(both.pipeline->staticMap(), finalOnly.pipeline->staticMap()));
}

TEST(PipelineLabels, WithoutVisibilityComeFromMotionAndVotesAlone) {
  PipelineOptions options;
  options.visibility.enabled = false;
  const auto scans = crossingScans(30);
  const PipelineRun run = runOf(scans, options);
  ASSERT_EQ(run.settled.size(), scans.size());
  EXPECT_GT(foundIn(scans, run.settled).recall, 0.5);
  EXPECT_GT(foundIn(scans, run.settled).precision, 0.9);
  EXPECT_FALSE(run.pipeline->staticMap().empty());
}

}  // namespace
}  // namespace toss::test
