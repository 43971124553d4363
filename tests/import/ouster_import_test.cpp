// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/import/OusterImport.h>
#include <toss/rawlog/InputSummary.h>
#include <toss/rawlog/PoseFile.h>
#include <toss/rawlog/SensorRecognition.h>

#include <algorithm>
#include <array>
#include <set>

#include "OusterFixtures.h"

namespace toss::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class OusterImport : public ::testing::Test {
 protected:
  OusterImportResult import(int frames, const std::vector<std::string>& payloads = {}) {
    writeBytes(folder / "meta.json", sensor.flatMetadata().dump());
    writeBytes(folder / "a.pcap",
               payloads.empty() ? sensor.capture(frames) : pcapOf(sensor.frames(payloads)));
    return importOuster(folder / "a.pcap", folder / "meta.json", folder / "a.rawlog", options);
  }

  void writePoses(PoseFileFormat format, const std::vector<double>& times) {
    std::vector<Eigen::Isometry3d> poses;
    for (std::size_t i = 0; i < times.size(); ++i)
      poses.push_back(poseOf(2.0 * static_cast<double>(i), 1.0, 0.5, 0.3));
    options.poses = folder / "poses.txt";
    writePoseFile(options.poses, format, times, poses);
  }

  TemporaryFolder folder;
  FakeOuster sensor;
  OusterImportOptions options;
};

TEST_F(OusterImport, WritesScansThatCanBeMapped) {
  writePoses(PoseFileFormat::Kitti, {0, 1, 2});
  double progress = 0.0;
  options.progress = [&](double share) {
    EXPECT_GE(share, progress);
    progress = share;
  };
  const OusterImportResult result = import(3);
  EXPECT_EQ(result.scans, 3u);
  EXPECT_EQ(result.posed, 3u);
  EXPECT_EQ(result.points, 3u * 8u * 512u);
  EXPECT_EQ(progress, 1.0);
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 3u);
  EXPECT_THAT(read.report.warnings, IsEmpty());
  for (std::size_t i = 0; i < 3; ++i) {
    const PosedScan& scan = read.scans[i];
    EXPECT_NEAR(scan.time, 1.65e9 + 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(scan.points.ring.size(), scan.points.size());
    EXPECT_EQ(scan.points.time.size(), scan.points.size());
    ASSERT_TRUE(scan.beams);
    EXPECT_EQ(scan.beams->name, "OS1-8");
    EXPECT_EQ(scan.sensorLabel, "OS1-8");
    // The LiDAR is above the housing's origin, of which the poses are.
    const Eigen::Isometry3d expected =
        poseOf(2.0 * static_cast<double>(i), 1.0, 0.5, 0.3) * poseOf(0, 0, 0.03618, 0);
    EXPECT_TRUE(scan.mapFromSensor.isApprox(expected, 1e-9));
  }
}

TEST_F(OusterImport, WorksWithoutPoses) {
  const OusterImportResult result = import(2);
  EXPECT_EQ(result.scans, 2u);
  EXPECT_EQ(result.posed, 0u);
  const InputSummary summary = summarizeInput(folder / "a.rawlog");
  EXPECT_EQ(summary.scans, 2u);
  EXPECT_EQ(summary.poses, 0u);
}

TEST_F(OusterImport, MovesCountersToUnixTime) {
  sensor.startTime = 42'000'000'000;
  const OusterImportResult result = import(3);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("counts time from its start")));
  // The capture's first packet came at 1.6e9.
  EXPECT_NEAR(summarizeInput(folder / "a.rawlog").streams.at(0).firstTime, 1.6e9, 1e-5);
  EXPECT_NEAR(summarizeInput(folder / "a.rawlog").streams.at(0).rate(), 10.0, 1e-4);
}

TEST_F(OusterImport, GoesOnWhereTheCounterFallsBack) {
  sensor.startTime = 42'000'000'000;
  std::vector<std::string> payloads = sensor.payloads(2);
  sensor.startTime = 1'000'000'000;
  const std::vector<std::string> after = sensor.payloads(2, 300);
  payloads.insert(payloads.end(), after.begin(), after.end());
  const OusterImportResult result = import(0, payloads);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("counter fell back")));
  // By the capture's clock the restart is at 0.064 s, but frame 1 was at 0.1 s by the sensor's.
  EXPECT_EQ(result.notLater, 1u);
  ASSERT_EQ(result.scans, 3u);
  EXPECT_NEAR(summarizeInput(folder / "a.rawlog").streams.at(0).lastTime, 1.6e9 + 0.164, 1e-5);
}

TEST_F(OusterImport, TellsClocksThatDiffer) {
  EXPECT_THAT(import(1).warnings, Contains(HasSubstr("-50000000.0 s behind")));
}

TEST_F(OusterImport, FindsPosesByEitherClock) {
  sensor.startTime = 42'000'000'000;
  writePoses(PoseFileFormat::Tum, {42.0, 42.1, 42.2});
  EXPECT_EQ(import(3).posed, 3u);
  writePoses(PoseFileFormat::Tum, {1.6e9 - 0.01, 1.6e9 + 0.1, 1.6e9 + 0.21});
  EXPECT_EQ(import(3).posed, 3u);
}

TEST_F(OusterImport, LeavesOutFramesWithoutAPose) {
  writePoses(PoseFileFormat::Kitti, {0, 1});
  const OusterImportResult result = import(3);
  EXPECT_EQ(result.scans, 2u);
  EXPECT_EQ(result.withoutPose, 1u);
  EXPECT_THAT(result.warnings, Contains(HasSubstr("1 frames were left out")));
}

TEST_F(OusterImport, LeavesNothingBehindWhenItFails) {
  writePoses(PoseFileFormat::Tum, {1.7e9, 1.7e9 + 1});
  EXPECT_THAT(userErrorOf([&] { import(2); }), HasSubstr("none of its 2 frames has a pose"));
  options.poses = folder / "none.txt";
  EXPECT_THAT(userErrorOf([&] { import(2); }), HasSubstr("none.txt"));
  options.poses.clear();
  std::vector<std::string> invalid;
  for (int column = 0; column < 512; column += 16)
    invalid.push_back(sensor.packet(0, column, false));
  EXPECT_THAT(userErrorOf([&] { import(0, invalid); }), HasSubstr("holds no frame"));
  std::set<std::string> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / ""))
    left.insert(entry.path().filename().string());
  EXPECT_THAT(left, ElementsAre("a.pcap", "meta.json", "poses.txt"));
}

/// Share of the returns of `scan` that share a voxel of 0.1 m with returns of `other`.
double overlap(const PosedScan& scan, const Eigen::Isometry3d& mapFromScan, const PosedScan& other,
               const Eigen::Isometry3d& mapFromOther) {
  const auto voxels = [](const PosedScan& s, const Eigen::Isometry3d& pose) {
    std::vector<std::array<int, 3>> result;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const Eigen::Vector3d point =
          pose * Eigen::Vector3d(s.points.x[i], s.points.y[i], s.points.z[i]);
      const Eigen::Vector3i cell = (10.0 * point).array().floor().cast<int>();
      result.push_back({cell.x(), cell.y(), cell.z()});
    }
    return result;
  };
  const auto theirs = voxels(other, mapFromOther);
  const std::set<std::array<int, 3>> occupied(theirs.begin(), theirs.end());
  const auto ours = voxels(scan, mapFromScan);
  const auto shared = std::count_if(ours.begin(), ours.end(),
                                    [&](const auto& cell) { return occupied.count(cell) > 0; });
  return static_cast<double>(shared) / static_cast<double>(ours.size());
}

TEST(OusterImportData, ScansOfARealDriveOverlapUnderTheirPoses) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const fs::path stem = dataFolder() / "ouster/OS-1-128_v2.3.0_1024x10";
  TemporaryFolder folder;
  OusterImportOptions options;
  options.poses = stem.string() + "_lb_n3_poses_kitti.txt";
  const OusterImportResult result =
      importOuster(stem.string() + "_lb_n3.pcap", stem.string() + ".json", folder / "a", options);
  EXPECT_EQ(result.scans, 3u);
  EXPECT_EQ(result.posed, 3u);
  EXPECT_EQ(result.frames.lostColumns, 0u);
  // As recorded: a scan that is put where one pose sees it has blurred beams.
  InputOptions asRecorded;
  asRecorded.deskew = Deskew::Off;
  const ReadInput read = readInput(folder / "a", asRecorded);
  ASSERT_EQ(read.scans.size(), 3u);
  const PosedScan &first = read.scans[0], &last = read.scans[2];
  const auto identity = Eigen::Isometry3d::Identity();
  const double posed = overlap(last, last.mapFromSensor, first, first.mapFromSensor);
  EXPECT_GT(posed, overlap(last, identity, first, identity) + 0.05);
  // A mirrored or turned scan would fit only under other poses.
  EXPECT_GT(posed, overlap(last, last.mapFromSensor.inverse(), first, identity) + 0.1);
  // Beams of the metadata, not those of a known model, describe the scans best.
  for (const SensorModel& known : knownSensors())
    EXPECT_LT(beamAgreement(read.scans[0].points, known).nearBeam, 0.8) << known.name;
  EXPECT_GT(beamAgreement(read.scans[0].points, *read.scans[0].beams).nearBeam, 0.99);
}

}  // namespace
}  // namespace toss::test
