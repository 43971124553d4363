// SPDX-License-Identifier: BSD-3-Clause
// Poses from a file in place of those of the input.
#include <InputFixtures.h>
#include <toss/rawlog/InputSummary.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/PoseFile.h>

namespace toss::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// KITTI's camera looks along the LiDAR's x, with its own x to the right and y down.
Eigen::Isometry3d cameraFromLidar() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  pose.translation() << 0.1, -0.2, -0.3;
  return pose;
}

class InputPoses : public ::testing::Test {
 protected:
  InputPoses() {
    for (std::size_t i = 0; i < kScans; ++i) {
      const double x = static_cast<double>(i);
      times_.push_back(makeScan(i).time);
      poses_.push_back(poseOf(100.0 + x, 2.0 * x, 0.1 * x, 0.1 * x));
    }
  }

  fs::path rawlog(const Eigen::Isometry3d& robotFromSensor, bool withPoses = false) {
    std::vector<Object> objects;
    for (std::size_t i = 0; i < kScans; ++i) {
      const PosedScan scan = makeScan(i);
      if (withPoses) objects.push_back(poseObservation(scan.time, scan.mapFromSensor));
      const auto cloud = cloudObservation(scan.time, scan);
      cloud->setSensorPose(toMrpt(robotFromSensor));
      objects.push_back(cloud);
    }
    writeObjects(folder_ / "a.rawlog", objects);
    return folder_ / "a.rawlog";
  }
  fs::path kitti() {
    KittiFolderWriter writer(folder_ / "kitti", cameraFromLidar());
    for (std::size_t i = 0; i < kScans; ++i) writer.write(makeScan(i));
    writer.commit();
    return folder_ / "kitti";
  }
  InputOptions use(PoseFileFormat format, const std::vector<Eigen::Isometry3d>& poses,
                   PoseSubject of = PoseSubject::Automatic) {
    writePoseFile(folder_ / "poses.txt", format, times_, poses);
    InputOptions options;
    options.poseFile = folder_ / "poses.txt";
    options.poseOf = of;
    return options;
  }
  void expectPoses(const ReadInput& read) const {
    ASSERT_EQ(read.scans.size(), kScans);
    for (std::size_t i = 0; i < kScans; ++i)
      EXPECT_TRUE(read.scans[i].mapFromSensor.isApprox(poses_[i], 1e-9)) << i;
  }

  static constexpr std::size_t kScans = 6;
  TemporaryFolder folder_;
  std::vector<double> times_;
  std::vector<Eigen::Isometry3d> poses_;
};

TEST_F(InputPoses, TakeThePlaceOfThoseOfARawlog) {
  for (const PoseFileFormat format : {PoseFileFormat::Tum, PoseFileFormat::Kitti})
    for (const bool withPoses : {false, true})
      expectPoses(readInput(rawlog(poseOf(1, 2, 3, 1), withPoses), use(format, poses_)));
}

TEST_F(InputPoses, OfTheRobotAreTurnedIntoThoseOfTheSensor) {
  const Eigen::Isometry3d robotFromSensor = poseOf(1, -0.5, 2, 1.5, 0.1);
  std::vector<Eigen::Isometry3d> ofRobot;
  for (const Eigen::Isometry3d& pose : poses_) ofRobot.push_back(pose * robotFromSensor.inverse());
  expectPoses(
      readInput(rawlog(robotFromSensor), use(PoseFileFormat::Tum, ofRobot, PoseSubject::Robot)));
}

TEST_F(InputPoses, InKittiFormatAreTheCamerasWhereTheFolderHasACalibration) {
  std::vector<Eigen::Isometry3d> ofCamera;
  for (const Eigen::Isometry3d& pose : poses_)
    ofCamera.push_back(cameraPose(pose, cameraFromLidar()));
  const fs::path folder = kitti();
  const ReadInput read = readInput(folder, use(PoseFileFormat::Kitti, ofCamera));
  expectPoses(read);
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("taken for those of the camera")));
  expectPoses(readInput(folder, use(PoseFileFormat::Tum, ofCamera, PoseSubject::Camera)));
  expectPoses(readInput(folder, use(PoseFileFormat::Tum, poses_)));
  expectPoses(readInput(folder, use(PoseFileFormat::Kitti, poses_, PoseSubject::Sensor)));
}

TEST_F(InputPoses, AreNotNeededWhereTheyAreToBeFound) {
  InputOptions options;
  options.withoutPoses = true;
  const fs::path folder = kitti();
  fs::remove(folder / "poses.txt");
  for (const fs::path& input : {rawlog(Eigen::Isometry3d::Identity()), folder}) {
    const ReadInput read = readInput(input, options);
    ASSERT_EQ(read.scans.size(), kScans);
    EXPECT_TRUE(read.scans[3].mapFromSensor.isApprox(Eigen::Isometry3d::Identity()));
  }
  EXPECT_THAT(userErrorOf([&] { readInput(folder); }), HasSubstr("--odometry"));
}

TEST_F(InputPoses, ThatCoverSomeScansLeaveTheOthersOut) {
  const fs::path folder = kitti(), log = rawlog(Eigen::Isometry3d::Identity());
  times_.resize(4), poses_.resize(4);
  for (const fs::path& input : {folder, log}) {
    const ReadInput read = readInput(input, use(PoseFileFormat::Tum, poses_));
    EXPECT_EQ(read.scans.size(), 4u);
    EXPECT_EQ(read.report.skippedForPose, 2u);
  }
}

TEST_F(InputPoses, ThatDoNotFitAreNamed) {
  const fs::path folder = kitti(), log = rawlog(Eigen::Isometry3d::Identity());
  for (double& time : times_) time += 1000.0;
  const InputOptions late = use(PoseFileFormat::Tum, poses_);
  EXPECT_THAT(userErrorOf([&] { readInput(folder, late); }), HasSubstr("input.time_offset"));
  EXPECT_THAT(userErrorOf([&] { readInput(log, late); }), HasSubstr("input.time_offset"));
  const InputOptions camera = use(PoseFileFormat::Tum, poses_, PoseSubject::Camera);
  EXPECT_THAT(userErrorOf([&] { readInput(log, camera); }), HasSubstr("input.pose_of=camera"));
  InputOptions missing;
  missing.poseFile = folder_ / "none.txt";
  for (const fs::path& input : {folder, log})
    EXPECT_THAT(userErrorOf([&] { readInput(input, missing); }), HasSubstr("none.txt"));
}

TEST_F(InputPoses, ShowInTheSummary) {
  const InputSummary summary =
      summarizeInput(rawlog(Eigen::Isometry3d::Identity()), use(PoseFileFormat::Kitti, poses_));
  EXPECT_EQ(summary.poses, kScans);
  EXPECT_EQ(summary.scansWithoutPose, 0u);
  EXPECT_EQ(summary.lowest.x(), 100.0);
}

}  // namespace
}  // namespace toss::test
