// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <iterator>
#include <set>

#include "SimulatedScans.h"

namespace toss::test {
namespace {

PipelineOptions everyReturn() {
  PipelineOptions options;
  options.mapping.voxelSize = 0.0;
  options.mapping.keepBelowGround = true;
  return options;
}

std::size_t staticReturns(const std::vector<ScanLabels>& all) {
  std::size_t count = 0;
  for (const ScanLabels& labels : all) count += countOf(labels, PointState::Static);
  return count;
}

TEST(PipelineMap, HoldsExactlyTheStaticReturnsWhereThereAreNoVoxels) {
  const PipelineRun run = runOf(crossingScans(20), everyReturn());
  EXPECT_EQ(run.pipeline->staticMap().size(), staticReturns(run.settled));
}

TEST(PipelineMap, PlacesReturnsByThePoseOfTheirScan) {
  const auto scans = crossingScans(1);
  const PipelineRun run = runOf(scans, everyReturn());
  const PosedScan& scan = scans.front().scan;
  std::vector<std::array<float, 3>> expected, found;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (run.settled.front().state[i] != PointState::Static) continue;
    const Eigen::Vector3d p =
        scan.mapFromSensor * Eigen::Vector3d(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
    expected.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  }
  for (const MapPoint& p : run.pipeline->staticMap()) found.push_back({p.x, p.y, p.z});
  ASSERT_EQ(found.size(), expected.size());
  std::array<double, 3> sumExpected{}, sumFound{};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      sumExpected[c] += static_cast<double>(expected[i][c]);
      sumFound[c] += static_cast<double>(found[i][c]);
    }
  const auto n = static_cast<double>(found.size());
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sumFound[c] / n, sumExpected[c] / n, 1e-4);
}

TEST(PipelineMap, BeforeTheEndIsThatOfTheScansTakenIn) {
  const auto scans = crossingScans(30);
  PipelineRun run(everyReturn());
  std::size_t before = 0;
  for (const SimulatedScan& each : scans) {
    run.process(each.scan);
    const std::size_t now = run.pipeline->staticMap().size();
    EXPECT_LE(now, before + 2 * each.scan.points.size());
    before = now;
  }
  // Asking in between changes nothing in the end.
  run.finish();
  EXPECT_TRUE(
      sameMap(run.pipeline->staticMap(), runOf(scans, everyReturn()).pipeline->staticMap()));
}

TEST(PipelineMap, IsFinalBeforeTheLastLabelsAreMade) {
  const auto scans = crossingScans(30);
  for (const PipelineOptions& options : {PipelineOptions(), everyReturn()}) {
    const PipelineRun whole = runOf(scans, options);
    PipelineRun inSteps(options);
    for (const SimulatedScan& each : scans) inSteps.process(each.scan);
    inSteps.pipeline->decideRest();
    for (ScanLabels labels; inSteps.pipeline->settleNext(labels);) {
      inSteps.settled.push_back(labels);
      EXPECT_TRUE(sameMap(inSteps.pipeline->staticMap(), whole.pipeline->staticMap()));
    }
    expectSameLabels(inSteps.settled, whole.settled);
  }
}

TEST(PipelineMap, IsEmptyBeforeTheFirstScan) {
  PipelineRun run;
  EXPECT_TRUE(run.pipeline->staticMap().empty());
  run.finish();
  EXPECT_TRUE(run.pipeline->staticMap().empty());
  EXPECT_TRUE(run.settled.empty());
}

TEST(PipelineMap, OfSettledScansStaysAsTheLabelsSay) {
  PipelineOptions options = everyReturn();
  options.voting.horizon = 2.5;
  options.voting.tauS = 1.0;
  options.visibility.offsets = "0.5 1";
  const PipelineRun run = runOf(crossingScans(45), options);
  ASSERT_EQ(run.settled.size(), 45u);
  EXPECT_EQ(run.pipeline->staticMap().size(), staticReturns(run.settled));
}

/// Every static return lies in a voxel of the map, and every voxel has one: what movers stood on is
/// told from them by this.
TEST(PipelineMap, HasTheVoxelsOfTheStaticReturns) {
  PipelineOptions options;
  options.mapping.keepBelowGround = true;
  options.mapping.voxelSize = 0.2;
  const auto scans = crossingScans(40);
  const PipelineRun run = runOf(scans, options);
  const Eigen::Vector3d origin = scans.front().scan.mapFromSensor.translation();
  const auto voxelOf = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = ((p - origin) / 0.2).array().floor();
    return std::array<int, 3>{static_cast<int>(q.x()), static_cast<int>(q.y()),
                              static_cast<int>(q.z())};
  };
  std::set<std::array<int, 3>> expected, found;
  for (std::size_t s = 0; s < scans.size(); ++s) {
    const PosedScan& scan = scans[s].scan;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      if (run.settled[s].state[i] == PointState::Static)
        expected.insert(
            voxelOf(scan.mapFromSensor *
                    Eigen::Vector3d(scan.points.x[i], scan.points.y[i], scan.points.z[i])));
  }
  const Eigen::Vector3d offset = run.pipeline->mapOffset();
  for (const MapPoint& p : run.pipeline->staticMap())
    found.insert(voxelOf(offset + Eigen::Vector3d(p.x, p.y, p.z)));
  std::vector<std::array<int, 3>> differ;
  std::set_symmetric_difference(expected.begin(), expected.end(), found.begin(), found.end(),
                                std::back_inserter(differ));
  // Returns within rounding of a face may count on its other side.
  EXPECT_LT(differ.size(), 1 + expected.size() / 1000);
  EXPECT_GT(found.size(), 10000u);
}

TEST(PipelineMap, MissesReturnsBelowTheGroundUnlessAskedFor) {
  PipelineOptions without = everyReturn();
  without.mapping.keepBelowGround = false;
  const auto scans = crossingScans(10);
  EXPECT_LE(runOf(scans, without).pipeline->staticMap().size(),
            runOf(scans, everyReturn()).pipeline->staticMap().size());
}

}  // namespace
}  // namespace toss::test
