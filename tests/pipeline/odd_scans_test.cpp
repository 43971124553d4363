// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>

#include <limits>
#include <stdexcept>

#include "SimulatedScans.h"

namespace toss::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Runs the crossing with scan number `odd` replaced by what `change` makes of it.
template <typename Change>
PipelineRun runWithOdd(std::size_t odd, Change change) {
  auto scans = crossingScans(15);
  change(scans[odd].scan);
  PipelineRun run = runOf(scans);
  EXPECT_EQ(run.live.size(), scans.size());
  EXPECT_EQ(run.settled.size(), scans.size());
  for (std::size_t s = 0; s < run.settled.size(); ++s)
    EXPECT_EQ(run.settled[s].state.size(), scans[s].scan.points.size());
  return run;
}

/// The scan in the middle, the first one and the last one.
class OddScans : public ::testing::TestWithParam<std::size_t> {};

TEST_P(OddScans, OfZeroPointsAreLivedThrough) {
  const PipelineRun run = runWithOdd(GetParam(), [](PosedScan& scan) { scan.points = {}; });
  EXPECT_TRUE(run.settled[GetParam()].state.empty());
  EXPECT_GT(countOf(run.settled[5], PointState::Static), 1000u);
}

TEST_P(OddScans, OfNothingButNanAreInvalidThroughout) {
  const PipelineRun run = runWithOdd(GetParam(), [](PosedScan& scan) {
    std::fill(scan.points.x.begin(), scan.points.x.end(), kNan);
  });
  const ScanLabels& labels = run.settled[GetParam()];
  EXPECT_EQ(countOf(labels, PointState::Invalid), labels.state.size());
}

TEST_P(OddScans, OfReturnsAtTheOriginAreInvalidThroughout) {
  const PipelineRun run = runWithOdd(GetParam(), [](PosedScan& scan) {
    for (auto* values : {&scan.points.x, &scan.points.y, &scan.points.z})
      std::fill(values->begin(), values->end(), 0.0f);
  });
  const ScanLabels& labels = run.settled[GetParam()];
  EXPECT_EQ(countOf(labels, PointState::Invalid), labels.state.size());
}

TEST_P(OddScans, OfASingleReturnAreLivedThrough) {
  runWithOdd(GetParam(), [](PosedScan& scan) {
    scan.points.resize(1);
    scan.points.x = {5.0f}, scan.points.y = {0.0f}, scan.points.z = {-1.0f};
  });
}

TEST_P(OddScans, WithoutIntensityAndRingsAreLabelledAlike) {
  const PipelineRun run = runWithOdd(GetParam(), [](PosedScan& scan) {
    scan.points.intensity.clear(), scan.points.ring.clear(), scan.points.time.clear();
  });
  EXPECT_GT(countOf(run.settled[GetParam()], PointState::Static), 10000u);
}

TEST_P(OddScans, FarAwayAndHugeReturnsDoNoHarm) {
  runWithOdd(GetParam(), [](PosedScan& scan) {
    scan.points.x[0] = std::numeric_limits<float>::max();
    scan.points.y[1] = -std::numeric_limits<float>::infinity();
    scan.points.z[2] = 1e7f;
    scan.points.x[3] = scan.points.y[3] = scan.points.z[3] = 1e-30f;
  });
}

INSTANTIATE_TEST_SUITE_P(At, OddScans, ::testing::Values(7, 0, 14));

TEST(PipelineInput, ThatIsNothingButEmptyScansGivesAnEmptyMap) {
  auto scans = crossingScans(4);
  for (SimulatedScan& each : scans) each.scan.points = {};
  const PipelineRun run = runOf(scans);
  EXPECT_EQ(run.settled.size(), 4u);
  EXPECT_TRUE(run.pipeline->staticMap().empty());
}

TEST(PipelineInput, ThatGoesBackInTimeIsAProgrammingError) {
  const auto scans = crossingScans(3);
  PipelineRun run;
  run.process(scans[1].scan);
  EXPECT_THROW(run.process(scans[0].scan), std::logic_error);
}

TEST(PipelineInput, WithALongPauseIsMappedOn) {
  auto scans = crossingScans(10);
  for (std::size_t s = 5; s < scans.size(); ++s) scans[s].scan.time += 3600.0;
  const PipelineRun run = runOf(scans);
  EXPECT_EQ(run.settled.size(), scans.size());
}

TEST(PipelineInput, OptionsOutOfRangeAreRefused) {
  PipelineOptions options;
  options.mapping.voxelSize = -1.0;
  EXPECT_THROW(runOf(crossingScans(1), options), UserError);
  options = {};
  options.voting.tauS = 0.4, options.voting.tauD = 0.5;
  EXPECT_THROW(PipelineRun{options}, UserError);
}

}  // namespace
}  // namespace toss::test
