// SPDX-License-Identifier: BSD-3-Clause
// Poses found from the scans alone, against the simulator's truth and the real sequence's poses.
#include <InputFixtures.h>
#include <tbb/global_control.h>
#include <toss/odometry/LidarOdometry.h>
#include <toss/simulation/Simulator.h>

namespace toss::test {
namespace {

struct Way {
  std::vector<Eigen::Isometry3d> truth, found;

  /// Deviation of the way from scan `a` to scan `b`.
  Eigen::Isometry3d error(std::size_t a, std::size_t b) const {
    return (truth[a].inverse() * truth[b]).inverse() * (found[a].inverse() * found[b]);
  }
  double length() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < truth.size(); ++i)
      sum += (truth[i].translation() - truth[i - 1].translation()).norm();
    return sum;
  }
  /// Error of the position at the end, as a share of the way.
  double relativeError() const {
    return error(0, truth.size() - 1).translation().norm() / length();
  }
};

Way driveThrough(SimulationOptions options, int scans) {
  Simulator simulator(options);
  LidarOdometry odometry({});
  SimulatedScan simulated;
  Way way;
  for (int i = 0; i < scans && simulator.next(simulated); ++i) {
    simulated.scan.motionCompensated = options.compensated;
    way.truth.push_back(simulated.trueMapFromSensor);
    way.found.push_back(odometry.add(simulated.scan));
  }
  return way;
}

Way driveThrough(const std::string& scene, int scans, const std::string& sensor = "") {
  SimulationOptions options;
  options.scene = scene;
  options.sensor = sensor;
  return driveThrough(options, scans);
}

TEST(LidarOdometry, StaysWithinOnePercentOfTheTruth) {
  EXPECT_LT(driveThrough("residential", 20).relativeError(), 0.01);
  EXPECT_LT(driveThrough("urban", 20, "VLP-16").relativeError(), 0.01);
}

TEST(LidarOdometry, FindsTheSpeedAtWhichALogBegins) {
  // 25 m/s from the first scan on, among vehicles of about the same speed.
  const Way way = driveThrough("highway", 10);
  EXPECT_GT(way.length(), 20.0);
  EXPECT_LT(way.relativeError(), 0.01);
}

TEST(LidarOdometry, TakesTheMotionOutOfTheSweep) {
  SimulationOptions options;
  options.scene = "residential";
  options.compensated = false;
  EXPECT_LT(driveThrough(options, 20).relativeError(), 0.01);
}

TEST(LidarOdometry, FollowsTheRealSequence) {
  const fs::path folder = dataFolder() / "kitti-tracking-0000";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const auto scans = openScans(folder, {});
  LidarOdometry odometry({});
  PosedScan scan;
  Way way;
  while (way.truth.size() < 40 && scans->next(scan)) {
    way.truth.push_back(scan.mapFromSensor);
    way.found.push_back(odometry.add(scan));
  }
  EXPECT_GT(way.length(), 10.0);
  // The reference itself is good to a few centimetres.
  EXPECT_LT(way.relativeError(), 0.01);
}

TEST(LidarOdometry, BearsScansWithoutReturns) {
  LidarOdometry odometry({});
  PosedScan scan = makeScan(0, 2000);
  const Eigen::Isometry3d first = odometry.add(scan);
  EXPECT_TRUE(first.isApprox(Eigen::Isometry3d::Identity()));
  scan.points.resize(0);
  scan.time += 0.1;
  EXPECT_TRUE(odometry.add(scan).matrix().allFinite());
  scan.points = makeScan(0, 2000).points;
  scan.time += 0.1;
  EXPECT_TRUE(odometry.add(scan).isApprox(Eigen::Isometry3d::Identity(), 0.05));
}

TEST(LidarOdometry, DoesNotDependOnTheNumberOfThreads) {
  const auto run = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return driveThrough("crossing", 5).found.back().matrix();
  };
  EXPECT_TRUE(run(1) == run(3));
}

TEST(LidarOdometry, RefusesOptionsOutOfRange) {
  OdometryOptions options;
  options.maxRange = 0.0;
  EXPECT_THAT(userErrorOf([&] { LidarOdometry{options}; }), ::testing::HasSubstr("max_range"));
}

TEST(ShareOfMotion, GoesOnAtTheSameVelocities) {
  const Eigen::Isometry3d turn = poseOf(1, 0, 0, 0.4);
  EXPECT_TRUE(shareOf(turn, 0.5).isApprox(poseOf(0.5, 0, 0, 0.2), 1e-12));
  EXPECT_TRUE(shareOf(turn, -1.0).isApprox(poseOf(-1, 0, 0, -0.4), 1e-12));
}

}  // namespace
}  // namespace toss::test
