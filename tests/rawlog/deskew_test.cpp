// SPDX-License-Identifier: BSD-3-Clause
// Returns that were measured on the way are put where they are seen from one pose.
#include <mrpt/poses/CPose3DInterpolator.h>
#include <toss/rawlog/RawlogWriter.h>

#include "VelodyneScans.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// 15 m/s along a curve of 0.8 rad/s, pitching.
Eigen::Isometry3d poseAt(double time) {
  const double t = time - 1000.0;
  return poseOf(15.0 * t, 3.0 * t * t, 0.2 * t, 0.3 + 0.8 * t, 0.1 * t, 0.05);
}

/// Poses every 50 ms, from before the scan at 1000 s to `last`.
std::vector<Object> posesUntil(double last) {
  std::vector<Object> objects;
  for (double time = 999.98; time <= last; time += 0.05)
    objects.push_back(poseObservation(time, poseAt(time)));
  return objects;
}

/// Largest distance of the points, in the map, from those that MRPT makes along the same path, as
/// share of what a packet's duration can make of it.
double worstAgainstMrpt(const PosedScan& scan, mrpt::obs::CObservationVelodyneScan& observation) {
  mrpt::poses::CPose3DInterpolator path;
  for (double time = 999.98; time <= 1000.4; time += 0.05)
    path.insert(toMrptTime(time), toMrpt(poseAt(time)).asTPose());
  std::vector<mrpt::math::TPointXYZIu8> expected;
  mrpt::obs::CObservationVelodyneScan::TGeneratePointCloudSE3Results stats;
  observation.generatePointCloudAlongSE3Trajectory(path, expected, stats);
  EXPECT_EQ(stats.num_correctly_inserted_points, expected.size());
  EXPECT_GE(scan.points.size(), expected.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const PointCloud& p = scan.points;
    const Eigen::Vector3d own = scan.mapFromSensor * Eigen::Vector3d(p.x[i], p.y[i], p.z[i]);
    const Eigen::Vector3d other(static_cast<double>(expected[i].pt.x),
                                static_cast<double>(expected[i].pt.y),
                                static_cast<double>(expected[i].pt.z));
    const double range = Eigen::Vector3f(p.x[i], p.y[i], p.z[i]).cast<double>().norm();
    worst = std::max(worst, (own - other).norm() / (1.4e-3 * (17.0 + 0.9 * (range + 3.0))));
  }
  return worst;
}

class DeskewedVelodyne : public ::testing::TestWithParam<VelodyneCase> {};

TEST_P(DeskewedVelodyne, IsAsMrptMakesItAlongThePath) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const auto observation = velodyneScan(GetParam());
  observation->sensorPose = toMrpt(poseOf(0.5, 0.1, 1.7, 0.2, 0.05));
  TemporaryFolder folder;
  std::vector<Object> objects = posesUntil(1000.4);
  // The poses of the sweep come after the scan.
  objects.insert(objects.begin() + 2, observation);
  writeObjects(folder / "a.rawlog", objects);

  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_EQ(read.report.deskewed, 1u);
  EXPECT_TRUE(read.scans[0].motionCompensated);
  EXPECT_LT(worstAgainstMrpt(read.scans[0], *observation), 1.0);

  InputOptions off;
  off.deskew = Deskew::Off;
  const ReadInput raw = readInput(folder / "a.rawlog", off);
  EXPECT_EQ(raw.report.deskewed + raw.report.notDeskewed, 0u);
  EXPECT_GT(worstAgainstMrpt(raw.scans.at(0), *observation), 20.0);
}

INSTANTIATE_TEST_SUITE_P(
    Models, DeskewedVelodyne,
    ::testing::Values(VelodyneCase{"sample_velodyne_vlp16_gps.pcap", "VLP16", "VLP-16", 75, 16},
                      VelodyneCase{"sample_velodyne_hdl32.pcap", "HDL32", "HDL-32E", 180, 32}));

/// A wall at x = 20 m of the map, seen from poseAt(), with times from -0.03 to 0.07 s.
PosedScan wallScan() {
  PosedScan scan = makeScan(0, 0);
  scan.time = 1000.0;
  scan.mapFromSensor = poseAt(1000.0);
  scan.points.resize(400);
  for (std::size_t i = 0; i < 400; ++i) {
    const double share = static_cast<double>(i) / 399.0;
    const Eigen::Vector3d onWall(20.0, -15.0 + 30.0 * share, 2.0 * std::sin(50.0 * share));
    scan.points.time.push_back(static_cast<float>(-0.03 + 0.1 * share));
    const Eigen::Vector3f seen =
        (poseAt(1000.0 + static_cast<double>(scan.points.time[i])).inverse() * onWall)
            .cast<float>();
    scan.points.x[i] = seen.x(), scan.points.y[i] = seen.y(), scan.points.z[i] = seen.z();
  }
  scan.points.x[7] = scan.points.y[7] = scan.points.z[7] = 0.0f;
  scan.points.y[8] = std::numeric_limits<float>::quiet_NaN();
  return scan;
}

double worstDistanceFromWall(const PosedScan& scan) {
  double worst = 0.0;
  for (std::size_t i = 9; i < scan.points.size(); ++i) {
    const PointCloud& p = scan.points;
    const Eigen::Vector3d inMap = scan.mapFromSensor * Eigen::Vector3d(p.x[i], p.y[i], p.z[i]);
    worst = std::max(worst, std::abs(inMap.x() - 20.0));
  }
  return worst;
}

/// Reads the wall with poses every 10 ms from `first` to `last`.
ReadInput readWall(const TemporaryFolder& folder, const PosedScan& wall, double first,
                   double last) {
  const fs::path log = folder / "a.rawlog";
  RawlogWriter writer(log);
  writer.writeWithoutPose(wall);
  for (double time = first; time <= last; time += 0.01)
    writer.write(*poseObservation(time, poseAt(time)));
  writer.commit();
  return readInput(log);
}

TEST(Deskew, AStraightWallIsStraight) {
  TemporaryFolder folder;
  EXPECT_GT(worstDistanceFromWall(wallScan()), 0.5);
  const ReadInput read = readWall(folder, wallScan(), 999.9, 1000.2);
  EXPECT_LT(worstDistanceFromWall(read.scans.at(0)), 2e-3);
  EXPECT_EQ(read.scans[0].points.x[7], 0.0f) << "no return stays none";
  EXPECT_TRUE(std::isnan(read.scans[0].points.x[8] + read.scans[0].points.y[8]));
}

TEST(Deskew, TheMotionGoesOnBeyondTheLastPose) {
  TemporaryFolder folder;
  const ReadInput read = readWall(folder, wallScan(), 999.9, 1000.005);
  EXPECT_EQ(read.report.deskewed, 1u);
  EXPECT_LT(worstDistanceFromWall(read.scans.at(0)), 0.1);
}

TEST(Deskew, WhatIsCompensatedStays) {
  TemporaryFolder folder;
  PosedScan wall = wallScan();
  wall.motionCompensated = true;
  const ReadInput read = readWall(folder, wall, 999.9, 1000.2);
  EXPECT_EQ(read.report.deskewed, 0u);
  EXPECT_TRUE(sameBits(read.scans.at(0).points.x, wall.points.x));
}

TEST(Deskew, ASinglePoseIsTooFew) {
  TemporaryFolder folder;
  const PosedScan wall = wallScan();
  const ReadInput read = readWall(folder, wall, 1000.0, 1000.005);
  EXPECT_TRUE(sameBits(read.scans.at(0).points.x, wall.points.x));
  EXPECT_FALSE(read.scans[0].motionCompensated);
  EXPECT_THAT(read.report.warnings.at(0), HasSubstr("1 scans could not be compensated"));
}

}  // namespace
}  // namespace toss::test
