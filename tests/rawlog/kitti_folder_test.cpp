// SPDX-License-Identifier: BSD-3-Clause
// Folders in KITTI layout: what is right about them, and every way in which they can be wrong.
#include <InputFixtures.h>

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kStraight =
    "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 2\n"
    "1 0 0 0 0 1 0 0 0 0 1 4\n";
/// Camera: x right, y down, z forward; 0.3 m before and 0.1 m under the LiDAR.
constexpr const char* kCalibration = "P0: 1 2 3\nTr: 0 -1 0 0 0 0 -1 -0.1 1 0 0 -0.3\n";

class KittiFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"000000", "000001", "000002"})
      writeBytes(velodyne / (std::string(name) + ".bin"), points(3));
    writeBytes(path / "poses.txt", kStraight);
    writeBytes(path / "calib.txt", kCalibration);
    writeBytes(path / "times.txt", "0.0\n0.11\n0.23\n");
  }

  static std::string points(std::size_t count) {
    std::string bytes;
    for (std::size_t i = 0; i < 4 * count; ++i) {
      const float value = 1.5f * static_cast<float>(i);
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
  }

  ReadInput read(const InputOptions& options = {}) { return readInput(path, options); }
  std::string error() {
    return userErrorOf([&] { read(); });
  }

  TemporaryFolder folder;
  fs::path path = folder / "sequences/07", velodyne = path / "velodyne";
};

TEST_F(KittiFolder, GivesLidarPosesTimesAndPoints) {
  const ReadInput input = read();
  ASSERT_EQ(input.scans.size(), 3u);
  EXPECT_THAT(input.report.warnings, IsEmpty());
  // 2 m forward in the camera's frame (z) are 2 m forward in the LiDAR's (x).
  EXPECT_TRUE(input.scans[1].mapFromSensor.isApprox(poseOf(2, 0, 0, 0), 1e-12));
  EXPECT_EQ(input.scans[2].time, 0.23);
  EXPECT_EQ(input.scans[2].index, 2u);
  EXPECT_EQ(input.scans[0].points.z[1], 9.0f);
  EXPECT_EQ(input.scans[0].points.intensity[2], 16.5f);
}

TEST_F(KittiFolder, RotatesAboutTheLidarAsTheFormulaSays) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  Eigen::Matrix4d tr = Eigen::Matrix4d::Identity(), p = Eigen::Matrix4d::Identity();
  tr.topRows<3>() << 0, -1, 0, 0, 0, 0, -1, -0.1, 1, 0, 0, -0.3;
  p.topRows<3>() << c, 0, s, 5, 0, 1, 0, -1, -s, 0, c, 9;
  std::ostringstream row;
  row.precision(17);
  row << c << " 0 " << s << " 5 0 1 0 -1 " << -s << " 0 " << c << " 9\n";
  writeBytes(path / "poses.txt", kStraight + row.str());
  writeBytes(path / "times.txt", "0\n1\n2\n3\n");
  writeBytes(velodyne / "000003.bin", points(1));
  const ReadInput input = read();
  EXPECT_TRUE(input.scans.at(3).mapFromSensor.matrix().isApprox(tr.inverse() * p * tr, 1e-12));
}

TEST_F(KittiFolder, FallsBackWithAWarning) {
  fs::remove(path / "times.txt");
  fs::remove(path / "calib.txt");
  const ReadInput input = read();
  ASSERT_EQ(input.scans.size(), 3u);
  EXPECT_NEAR(input.scans[2].time, 0.2, 1e-7);
  EXPECT_TRUE(input.scans[1].mapFromSensor.isApprox(poseOf(0, 0, 2, 0), 1e-12));
  EXPECT_THAT(input.report.warnings, Contains(HasSubstr("times.txt: does not exist")));
  EXPECT_THAT(input.report.warnings, Contains(HasSubstr("poses of the LiDAR itself")));
  InputOptions options;
  options.scanPeriod = 0.05;
  EXPECT_NEAR(read(options).scans[2].time, 0.1, 1e-7);
}

TEST_F(KittiFolder, FindsPosesInTheirOtherPlace) {
  fs::create_directories(folder / "poses");
  fs::rename(path / "poses.txt", folder / "poses/07.txt");
  EXPECT_EQ(read().scans.size(), 3u);
  fs::remove(folder / "poses/07.txt");
  EXPECT_THAT(error(), HasSubstr("poses.txt: does not exist"));
}

TEST_F(KittiFolder, PointsThatAreNoNumbersStayInPlace) {
  std::string bytes = points(1);
  const float notANumber = std::numeric_limits<float>::quiet_NaN();
  bytes.append(reinterpret_cast<const char*>(&notANumber), sizeof notANumber);
  bytes += points(1).substr(4);
  writeBytes(velodyne / "000001.bin", bytes + points(1));
  const ReadInput input = read();
  ASSERT_EQ(input.scans[1].points.size(), 3u);
  EXPECT_TRUE(std::isnan(input.scans[1].points.x[1]));
  EXPECT_EQ(input.report.notFinite, 1u);
}

TEST_F(KittiFolder, EmptyScanIsDeliveredAndCounted) {
  writeBytes(velodyne / "000001.bin", "");
  const ReadInput input = read();
  ASSERT_EQ(input.scans.size(), 3u);
  EXPECT_TRUE(input.scans[1].points.empty());
  EXPECT_EQ(input.report.empty, 1u);
}

TEST_F(KittiFolder, ScanThatIsCutOff) {
  writeBytes(velodyne / "000001.bin", points(3).substr(0, 45));
  EXPECT_THAT(error(), AllOf(HasSubstr("000001.bin"), HasSubstr("45 bytes"), HasSubstr("of 16")));
}

TEST_F(KittiFolder, FewerPosesThanScans) {
  writeBytes(path / "poses.txt", std::string(kStraight).substr(0, 48));
  const ReadInput input = read();
  EXPECT_EQ(input.scans.size(), 2u);
  EXPECT_EQ(input.report.skippedForPose, 1u);
  EXPECT_THAT(input.report.warnings, Contains(HasSubstr("from number 2 on have no pose")));
}

TEST_F(KittiFolder, NumbersThatCanNotBeRowsOfPoses) {
  for (int i = 2; i >= 0; --i)
    fs::rename(velodyne / ("00000" + std::to_string(i) + ".bin"),
               velodyne / ("00000" + std::to_string(i + 4) + ".bin"));
  EXPECT_THAT(error(), AllOf(HasSubstr("3 rows"), HasSubstr("number 6")));
}

TEST_F(KittiFolder, GapsInTheNumbersAndOtherFiles) {
  fs::remove(velodyne / "000001.bin");
  writeBytes(velodyne / "readme.txt", "text");
  const ReadInput input = read();
  ASSERT_EQ(input.scans.size(), 2u);
  EXPECT_EQ(input.scans[1].index, 2u);
  EXPECT_TRUE(input.scans[1].mapFromSensor.isApprox(poseOf(4, 0, 0, 0), 1e-12));
  EXPECT_THAT(input.report.warnings, Contains(HasSubstr("1 numbers between")));
  EXPECT_THAT(input.report.warnings, Contains(HasSubstr("1 entries are not named")));
}

TEST_F(KittiFolder, PosesThatAreNone) {
  for (const char* row :
       {"1 0 0 0 0 1 0 0 0 0 1\n", "1 0 0 0 0 1 0 0 0 0 1 0 7\n", "1 0 text\n",
        "2 0 0 0 0 2 0 0 0 0 2 0\n", "nan 0 0 0 0 1 0 0 0 0 1 0\n", "1 0 0 0 0 1 0 0 0 0 -1 0\n"}) {
    writeBytes(path / "poses.txt", std::string("1 0 0 0 0 1 0 0 0 0 1 0\n") + row);
    EXPECT_THAT(error(), HasSubstr("poses.txt: line 2: is no pose")) << row;
  }
  writeBytes(path / "poses.txt", "");
  EXPECT_THAT(error(), HasSubstr("holds 0 rows"));
}

TEST_F(KittiFolder, CalibrationWithoutTr) {
  writeBytes(path / "calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(error(), HasSubstr("calib.txt: holds no \"Tr:\""));
  writeBytes(path / "calib.txt", "Tr:\n");
  EXPECT_THAT(error(), HasSubstr("calib.txt: line 1"));
}

TEST_F(KittiFolder, TimesThatAreWrong) {
  writeBytes(path / "times.txt", "0.0\n0.2\n0.1\n");
  EXPECT_THAT(error(), HasSubstr("times.txt: line 3: is not later"));
  writeBytes(path / "times.txt", "0.0\n0.2\n");
  EXPECT_THAT(error(), HasSubstr("holds 2 times, but 3 scans need one"));
  writeBytes(path / "times.txt", "0.0\nsoon\n0.3\n");
  EXPECT_THAT(error(), HasSubstr("times.txt: line 2: is no time"));
}

TEST_F(KittiFolder, FoldersOfAnotherLayout) {
  EXPECT_THAT(userErrorOf([&] { readInput(velodyne); }), HasSubstr("has no folder velodyne/"));
  fs::remove_all(velodyne);
  fs::create_directories(velodyne);
  EXPECT_THAT(error(), HasSubstr("holds no scan"));
}

TEST_F(KittiFolder, ErrorsAreOneLine) {
  writeBytes(path / "poses.txt", "text\n");
  EXPECT_THAT(error(), AllOf(Not(IsEmpty()), Not(HasSubstr("\n"))));
}

TEST(KittiData, HundredRealScans) {
  const fs::path folder = dataFolder() / "kitti-tracking-0000";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const auto source = openScans(folder, {});
  EXPECT_EQ(source->scanCount(), 100u);
  PosedScan scan;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < 100; ++i) {
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.points.size(), fs::file_size(folder / "velodyne" /
                                                fs::path("000000.bin")
                                                    .replace_filename((i < 10 ? "00000" : "0000") +
                                                                      std::to_string(i) + ".bin")) /
                                      16);
    EXPECT_EQ(scan.sensorModel, "HDL-64E");
    // A car: at most 20 m/s, and level to some degrees.
    const double step = i == 0 ? 0.0 : (scan.mapFromSensor.translation() - last).norm();
    EXPECT_LT(step, 2.0);
    EXPECT_GT(scan.mapFromSensor(2, 2), 0.99);
    last = scan.mapFromSensor.translation();
  }
  EXPECT_FALSE(source->next(scan));
  EXPECT_EQ(source->progress(), 1.0);
  EXPECT_EQ(labelsFolderOf(folder), folder / "labels");
}

}  // namespace
}  // namespace toss::test
