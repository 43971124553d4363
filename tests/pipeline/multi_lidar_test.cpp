// SPDX-License-Identifier: BSD-3-Clause
#include <toss/pipeline/MultiLidarPipeline.h>

#include <set>

#include "SimulatedScans.h"

namespace toss::test {
namespace {

constexpr const char* kFront = "front";
constexpr const char* kRear = "rear";

/// The crossing as two LiDARs on one robot see it, in order of time.
std::vector<PosedScan> scansOfBoth(int frames) {
  SimulationOptions options;
  options.scene = "crossing";
  options.frames = frames;
  options.threads = 1;
  Simulator front(options);
  options.sensor = "OS1-64";
  options.startTime = 0.05;
  options.robotFromSensor = Eigen::Translation3d(-0.5, 0.0, -0.2) *
                            Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()) *
                            Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY());
  Simulator rear(options);
  std::vector<PosedScan> scans;
  SimulatedScan scan;
  while (front.next(scan)) {
    scan.scan.sensorLabel = kFront;
    scans.push_back(scan.scan);
    if (!rear.next(scan)) break;
    scan.scan.sensorLabel = kRear;
    scans.push_back(scan.scan);
  }
  for (std::size_t i = 0; i < scans.size(); ++i) scans[i].index = i;
  return scans;
}

struct BothRun {
  explicit BothRun(const PipelineOptions& options) {
    pipeline.add(kFront, options, sensorByName("VLP-16"));
    pipeline.add(kRear, options, sensorByName("OS1-64"));
  }
  void process(const PosedScan& scan) {
    pipeline.process(scan);
    take();
  }
  void finish() {
    pipeline.finish();
    take();
  }
  void take() {
    for (ScanLabels& labels : pipeline.takeSettled()) settled.push_back(std::move(labels));
  }

  MultiLidarPipeline pipeline;
  std::vector<ScanLabels> settled;
};

BothRun runOfBoth(const std::vector<PosedScan>& scans, const PipelineOptions& options) {
  BothRun run(options);
  for (const PosedScan& scan : scans) run.process(scan);
  run.finish();
  return run;
}

/// A pipeline for the scans of one label alone.
PipelineRun runOfOne(const std::vector<PosedScan>& scans, const std::string& label,
                     const std::string& sensor, const PipelineOptions& options) {
  PipelineRun run(options);
  run.pipeline = std::make_unique<Pipeline>(options, sensorByName(sensor));
  for (const PosedScan& scan : scans)
    if (scan.sensorLabel == label) run.process(scan);
  run.finish();
  return run;
}

PipelineOptions optionsWithVoxels(double size) {
  PipelineOptions options;
  options.mapping.voxelSize = size;
  return options;
}

/// But for residue, of which all LiDARs together say whether anything else was in its place.
TEST(MultiLidar, GivesEachLidarTheLabelsThatItHasAlone) {
  const auto scans = scansOfBoth(15);
  PipelineOptions options;
  options.decision.residuePlace = 0.0;
  const BothRun both = runOfBoth(scans, options);
  const PipelineRun front = runOfOne(scans, kFront, "VLP-16", options);
  const PipelineRun rear = runOfOne(scans, kRear, "OS1-64", options);
  ASSERT_EQ(both.settled.size(), scans.size());
  std::size_t moving[2] = {0, 0};
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const ScanLabels& alone = (i % 2 == 0 ? front : rear).settled.at(i / 2);
    EXPECT_EQ(both.settled[i].scan, i);
    EXPECT_TRUE(both.settled[i].state == alone.state) << i;
    moving[i % 2] += countOf(both.settled[i], PointState::Moving);
  }
  EXPECT_GT(moving[0], 100u);
  EXPECT_GT(moving[1], 100u);
}

TEST(MultiLidar, HasOneMapWithTheReturnsOfAll) {
  const auto scans = scansOfBoth(15);
  const PipelineOptions options = optionsWithVoxels(0.0);
  const BothRun both = runOfBoth(scans, options);
  const PipelineRun front = runOfOne(scans, kFront, "VLP-16", options);
  const PipelineRun rear = runOfOne(scans, kRear, "OS1-64", options);
  EXPECT_EQ(both.pipeline.staticMap().size(),
            front.pipeline->staticMap().size() + rear.pipeline->staticMap().size());
}

/// A voxel that only both together have seen often enough is kept.
TEST(MultiLidar, CountsTheReturnsOfAllInAVoxel) {
  const auto scans = scansOfBoth(15);
  PipelineOptions options = optionsWithVoxels(0.2);
  options.mapping.minPoints = 3;
  const std::size_t both = runOfBoth(scans, options).pipeline.staticMap().size();
  const std::size_t front = runOfOne(scans, kFront, "VLP-16", options).pipeline->staticMap().size();
  const std::size_t rear = runOfOne(scans, kRear, "OS1-64", options).pipeline->staticMap().size();
  EXPECT_GT(both, std::max(front, rear));
  EXPECT_LT(both, front + rear);
}

TEST(MultiLidar, SettlesInStepsInOrderOfComing) {
  const auto scans = scansOfBoth(15);
  const BothRun whole = runOfBoth(scans, {});
  BothRun inSteps({});
  for (const PosedScan& scan : scans) inSteps.process(scan);
  inSteps.pipeline.decideRest();
  for (ScanLabels labels; inSteps.pipeline.settleNext(labels);) inSteps.settled.push_back(labels);
  expectSameLabels(inSteps.settled, whole.settled);
  EXPECT_TRUE(sameMap(inSteps.pipeline.staticMap(), whole.pipeline.staticMap()));
}

TEST(MultiLidar, NumbersTracesOnce) {
  const auto scans = scansOfBoth(15);
  const BothRun both = runOfBoth(scans, {});
  std::set<TrackId> of[2];
  for (std::size_t i = 0; i < both.settled.size(); ++i)
    for (const TrackSample& sample : both.settled[i].tracks) of[i % 2].insert(sample.track);
  EXPECT_FALSE(of[0].empty() || of[1].empty());
  for (const TrackId track : of[0]) EXPECT_EQ(of[1].count(track), 0u) << track;
  // None is left out: the number of traces is the largest number.
  EXPECT_EQ(of[0].size() + of[1].size(), std::max(*of[0].rbegin(), *of[1].rbegin()));
}

TEST(MultiLidar, DoesNotWaitForALidarThatFellSilent) {
  auto scans = scansOfBoth(40);
  PipelineOptions options;
  options.voting.horizon = 2.5;
  options.voting.tauS = 1.0;
  options.visibility.offsets = "0.5 1";
  BothRun run(options);
  std::size_t given = 0;
  for (PosedScan& scan : scans) {
    if (scan.sensorLabel == kRear && scan.index > 20) continue;
    if (scan.index > 20) scan.time += 65.0;
    run.process(scan);
    ++given;
  }
  // What came before the gap is final, though the rear LiDAR never came back.
  EXPECT_GE(run.settled.size(), 21u);
  run.finish();
  EXPECT_EQ(run.settled.size(), given);
}

TEST(MultiLidar, RefusesScansOfStrangers) {
  BothRun run({});
  PosedScan scan;
  scan.sensorLabel = "unknown";
  EXPECT_THROW(run.process(scan), std::logic_error);
  EXPECT_THROW(run.pipeline.add(kRear, {}, sensorByName("VLP-16")), std::logic_error);
}

}  // namespace
}  // namespace toss::test
