// SPDX-License-Identifier: BSD-3-Clause
// Returns without times are put where they are seen from one pose, where the sweep is known.
#include <toss/rawlog/RawlogWriter.h>

#include <cmath>

#include "InputFixtures.h"

namespace toss::test {
namespace {

constexpr double kWall = 30.0;

/// 15 m/s along a curve of 0.6 rad/s.
Eigen::Isometry3d poseAt(double time) {
  const double t = time - 1000.0;
  return poseOf(15.0 * t, 2.0 * t * t, 0.0, 0.3 + 0.6 * t);
}

/// How far a ray goes to the round wall about the map's origin.
double rangeToWall(const Eigen::Isometry3d& mapFromSensor, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d from = mapFromSensor.translation(),
                        along = mapFromSensor.linear() * direction;
  const double b = from.head<2>().dot(along.head<2>());
  return -b + std::sqrt(b * b - from.head<2>().squaredNorm() + kWall * kWall);
}

/// What a LiDAR sees of the wall that begins a sweep at azimuth `start` [rad], `stamp` of a sweep
/// before the time stamp, and turns with `sense` 1 (to the left) or -1 at `rate`.
PosedScan sweep(double start, double stamp, double sense, double rate) {
  PosedScan scan = makeScan(0, 0);
  scan.time = 1000.0;
  scan.sensorLabel = "lidar";
  scan.points.resize(500);
  for (std::size_t i = 0; i < 500; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / 500.0;
    const double azimuth = start + sense * 2.0 * M_PI * share;
    const Eigen::Vector3d direction(std::cos(azimuth), std::sin(azimuth), 0.0);
    const Eigen::Isometry3d pose = poseAt(1000.0 + (share - stamp) / rate);
    const Eigen::Vector3f p = (rangeToWall(pose, direction) * direction).cast<float>();
    scan.points.x[i] = p.x(), scan.points.y[i] = p.y(), scan.points.z[i] = p.z();
  }
  return scan;
}

ReadInput readSweep(const PosedScan& scan, const InputOptions& options) {
  const TemporaryFolder folder;
  RawlogWriter writer(folder / "a.rawlog");
  writer.writeWithoutPose(scan);
  for (int i = -20; i <= 20; ++i)
    writer.write(*poseObservation(1000.0 + 0.01 * i, poseAt(1000.0 + 0.01 * i)));
  writer.commit();
  return readInput(folder / "a.rawlog", options);
}

double worstDistanceFromWall(const ReadInput& read) {
  const PosedScan& scan = read.scans.at(0);
  double worst = 0.0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d inMap =
        scan.mapFromSensor *
        Eigen::Vector3f(scan.points.x[i], scan.points.y[i], scan.points.z[i]).cast<double>();
    worst = std::max(worst, std::abs(inMap.head<2>().norm() - kWall));
  }
  return worst;
}

TEST(KnownSweep, MakesARoundWallRound) {
  InputOptions options;
  options.deskew = Deskew::Sweep;
  const PosedScan usual = sweep(M_PI, 0.5, -1.0, 10.0);
  const ReadInput read = readSweep(usual, options);
  EXPECT_EQ(read.report.deskewed, 1u);
  EXPECT_LT(worstDistanceFromWall(read), 2e-3);
}

TEST(KnownSweep, TakesSenseStartStampAndRate) {
  InputOptions options;
  options.deskew = Deskew::Sweep;
  options.sweepSense = SweepSense::Counterclockwise;
  options.sweepStart = 30.0;
  options.sweepStamp = 1.0;
  options.sweepRate = 20.0;
  const PosedScan other = sweep(M_PI / 6.0, 1.0, 1.0, 20.0);
  EXPECT_LT(worstDistanceFromWall(readSweep(other, options)), 2e-3);
  options.sweepSense = SweepSense::Clockwise;
  EXPECT_GT(worstDistanceFromWall(readSweep(other, options)), 0.3);
}

TEST(KnownSweep, IsNeverAssumed) {
  const PosedScan usual = sweep(M_PI, 0.5, -1.0, 10.0);
  const ReadInput read = readSweep(usual, {});
  EXPECT_EQ(read.report.deskewed, 0u);
  EXPECT_GT(worstDistanceFromWall(read), 0.3);
}

TEST(KnownSweep, LeavesCompensatedScansAlone) {
  InputOptions options;
  options.deskew = Deskew::Sweep;
  PosedScan scan = sweep(M_PI, 0.5, -1.0, 10.0);
  scan.motionCompensated = true;
  scan.points.ring.assign(scan.points.size(), 0);
  EXPECT_EQ(readSweep(scan, options).report.deskewed, 0u);
}

}  // namespace
}  // namespace toss::test
