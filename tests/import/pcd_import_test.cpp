// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <PcdFixtures.h>
#include <toss/import/PcdImport.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/PoseFile.h>

namespace toss::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kPoints = 60;

Eigen::Isometry3d sensorPose(std::size_t scan) {
  return poseOf(100.0 + 2.0 * static_cast<double>(scan), -40.0, 1.5, 0.4, 0.02, -0.01);
}

/// Point `i` of a scan in the sensor frame.
Eigen::Vector3d pointAt(std::size_t scan, std::size_t i) {
  const auto angle = 0.1 * static_cast<double>(i);
  return {10.0 * std::cos(angle), 8.0 * std::sin(angle), 0.1 * static_cast<double>(scan)};
}

class PcdImport : public ::testing::Test {
 protected:
  void write(const std::string& name, std::size_t scan, PcdData data, bool inMap = true) {
    std::vector<MapPoint> points;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const Eigen::Vector3d point = inMap ? sensorPose(scan) * pointAt(scan, i) : pointAt(scan, i);
      const Eigen::Vector3f p = point.cast<float>();
      points.push_back({p.x(), p.y(), p.z(), i % 3 == 0 ? 1.0f : 0.0f});
    }
    writeBytes(folder / ("in/pcd/" + name), pcdOf(points, data, viewpointOf(sensorPose(scan))));
  }
  void writeAll(bool inMap = true) {
    write("000007.pcd", 0, PcdData::Ascii, inMap);
    write("000008.pcd", 1, PcdData::Binary, inMap);
    write("000010.pcd", 2, PcdData::Compressed, inMap);
  }
  PcdImportResult import() { return importPcd(folder / "in", rawlog, options); }
  void expectScans() {
    const ReadInput read = readInput(rawlog);
    ASSERT_EQ(read.scans.size(), 3u);
    for (std::size_t s = 0; s < 3; ++s) {
      const PosedScan& scan = read.scans[s];
      EXPECT_TRUE(scan.mapFromSensor.isApprox(sensorPose(s), 1e-8));
      ASSERT_EQ(scan.points.size(), kPoints);
      for (std::size_t i = 0; i < kPoints; ++i)
        EXPECT_LT(
            (Eigen::Vector3d(scan.points.x[i], scan.points.y[i], scan.points.z[i]) - pointAt(s, i))
                .norm(),
            2e-5);
    }
  }

  TemporaryFolder folder;
  fs::path rawlog = folder / "out.rawlog";
  PcdImportOptions options;
};

TEST_F(PcdImport, BringsPointsIntoTheSensorFrame) {
  writeAll();
  // The benchmark's true map lies beside the folder of scans.
  writeBytes(folder / "in/gt_cloud.pcd", "not read");
  const PcdImportResult result = import();
  EXPECT_EQ(result.scans, 3u);
  EXPECT_EQ(result.points, 3 * kPoints);
  EXPECT_THAT(result.warnings, IsEmpty());
  expectScans();
  const ReadInput read = readInput(rawlog);
  EXPECT_NEAR(read.scans[2].time - read.scans[0].time, 0.3, 1e-6) << "numbers tell the time";
  EXPECT_EQ(read.scans[0].points.intensity[3], 1.0f);
  EXPECT_TRUE(labelsFolderOf(rawlog).empty());
}

TEST_F(PcdImport, TakesLabelsFromTheIntensity) {
  writeAll();
  options.labelsFromIntensity = true;
  EXPECT_EQ(import().moving, 3 * kPoints / 3);
  const std::vector<std::uint32_t> labels =
      readLabels(labelPath(labelsFolderOf(rawlog), 2), kPoints);
  for (std::size_t i = 0; i < kPoints; ++i)
    EXPECT_EQ(labels[i], i % 3 == 0 ? label::kFirstMoving : label::kStatic);
  EXPECT_EQ(readInput(rawlog).scans[0].points.intensity[3], 0.0f);
}

TEST_F(PcdImport, TakesPointsInTheSensorFrameAndWarnsWhereTheFrameIsMistaken) {
  writeAll(false);
  EXPECT_THAT(import().warnings, ElementsAre(HasSubstr("--frame sensor")));
  options.frame = PcdImportOptions::Frame::Sensor;
  EXPECT_THAT(import().warnings, IsEmpty());
  expectScans();
  writeAll(true);
  EXPECT_THAT(import().warnings, ElementsAre(HasSubstr("--frame map")));
}

TEST_F(PcdImport, WarnsWhereThePosesWereForgotten) {
  for (const char* name : {"1.pcd", "2.pcd"}) write(name, 0, PcdData::Binary);
  EXPECT_THAT(import().warnings, ElementsAre(HasSubstr("all scans have the same pose")));
}

TEST_F(PcdImport, TakesPosesFromAFile) {
  writeAll(false);
  options.frame = PcdImportOptions::Frame::Sensor;
  options.poses = folder / "poses.txt";
  writePoseFile(options.poses, PoseFileFormat::Kitti, {0.0, 1.0},
                {poseOf(1, 2, 3, 0), poseOf(2, 2, 3, 0.1)});
  const PcdImportResult result = import();
  EXPECT_EQ(result.scans, 2u);
  EXPECT_EQ(result.withoutPose, 1u);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("1 files were left out")));
  EXPECT_TRUE(readInput(rawlog).scans[1].mapFromSensor.isApprox(poseOf(2, 2, 3, 0.1), 1e-9));
}

TEST_F(PcdImport, OrdersFilesByNumberOrElseByName) {
  write("10.pcd", 1, PcdData::Binary);
  write("9.pcd", 0, PcdData::Binary);
  import();
  EXPECT_TRUE(readInput(rawlog).scans[0].mapFromSensor.isApprox(sensorPose(0), 1e-8));
  write("last.pcd", 2, PcdData::Binary);
  import();
  const ReadInput read = readInput(rawlog);
  EXPECT_TRUE(read.scans[0].mapFromSensor.isApprox(sensorPose(1), 1e-8));
  EXPECT_NEAR(read.scans[2].time - read.scans[0].time, 0.2, 1e-6);
}

TEST_F(PcdImport, LeavesNothingBehindWhenItFails) {
  EXPECT_THAT(userErrorOf([&] { import(); }), HasSubstr("is no folder"));
  fs::create_directories(folder / "in");
  EXPECT_THAT(userErrorOf([&] { import(); }), HasSubstr("holds no PCD files"));
  writeAll();
  write("10.pcd", 1, PcdData::Binary);
  EXPECT_THAT(userErrorOf([&] { import(); }), HasSubstr("same number"));
  fs::remove(folder / "in/pcd/10.pcd");
  writeBytes(folder / "in/pcd/000011.pcd", pcdOf({{1, 2, 3, 0.4f}}, PcdData::Ascii, ""));
  EXPECT_THAT(userErrorOf([&] { import(); }), HasSubstr("no line VIEWPOINT"));
  writeBytes(folder / "in/pcd/000011.pcd",
             pcdOf({{1, 2, 3, 0.4f}}, PcdData::Ascii, viewpointOf(sensorPose(0))));
  options.labelsFromIntensity = true;
  EXPECT_THAT(userErrorOf([&] { import(); }),
              ::testing::AllOf(HasSubstr("000011.pcd"), HasSubstr("0.4")));
  options.period = 0.0;
  EXPECT_THAT(userErrorOf([&] { import(); }), HasSubstr("--period"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / ""), {}), 1);
}

}  // namespace
}  // namespace toss::test
