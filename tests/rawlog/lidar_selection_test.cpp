// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/LidarSelection.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::size_t kReturns = 400;

/// A cloud of `points` returns at a place on the robot.
Object cloudOf(double time, std::uint64_t seed, const std::string& label,
               const Eigen::Isometry3d& robotFromSensor, std::size_t points = kReturns) {
  auto cloud = cloudObservation(time, makeScan(seed, points), label);
  cloud->sensorPose = toMrpt(robotFromSensor);
  return cloud;
}

/// The returns of a scan in the frame of the robot.
Object cloudInRobotFrame(double time, std::uint64_t seed, const std::string& label,
                         const Eigen::Isometry3d& robotFromSensor) {
  PosedScan scan = makeScan(seed, kReturns);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f p = robotFromSensor.cast<float>() *
                              Eigen::Vector3f(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
    scan.points.x[i] = p.x(), scan.points.y[i] = p.y(), scan.points.z[i] = p.z();
  }
  return cloudObservation(time, scan, label);
}

const Eigen::Isometry3d kFront = poseOf(1.0, 0.2, 0.5, 0.3, 0.1);
const Eigen::Isometry3d kRear = poseOf(-1.0, 0.0, 0.7, 3.0);

class LidarSelectionTest : public ::testing::Test {
 protected:
  LidarSelection select(const std::vector<Object>& objects, const InputOptions& options = {}) {
    writeObjects(folder_ / "a.rawlog", objects);
    return selectLidars(folder_ / "a.rawlog", options);
  }
  TemporaryFolder folder_;
};

TEST_F(LidarSelectionTest, HasNothingToChooseWithOneSensor) {
  EXPECT_THAT(select(logOf(3)).labels, IsEmpty());
}

TEST_F(LidarSelectionTest, TakesAllInTheOrderInWhichTheyAreMet) {
  const auto selection = select({cloudOf(1.0, 1, "front", kFront), cloudOf(1.05, 2, "rear", kRear),
                                 cloudOf(1.1, 3, "front", kFront)});
  EXPECT_THAT(selection.labels, ElementsAre("front", "rear"));
  EXPECT_THAT(selection.notes, IsEmpty());
}

TEST_F(LidarSelectionTest, TakesTheOneThatIsNamedAlone) {
  InputOptions options;
  options.sensorLabel = "rear";
  EXPECT_THAT(
      select({cloudOf(1.0, 1, "front", kFront), cloudOf(1.0, 2, "rear", kRear)}, options).labels,
      IsEmpty());
}

TEST_F(LidarSelectionTest, LeavesOutWhatSitsAtTheSamePlace) {
  const auto selection = select({cloudOf(1.0, 1, "raw", kFront), cloudOf(1.0, 2, "cloud", kFront),
                                 cloudOf(1.0, 3, "rear", kRear)});
  EXPECT_THAT(selection.labels, ElementsAre("raw", "rear"));
  EXPECT_THAT(selection.notes, ElementsAre(HasSubstr("'cloud' are left out, it sits where 'raw'")));
}

TEST_F(LidarSelectionTest, LeavesOutTheSameReturnsInAnotherFrame) {
  const auto selection =
      select({cloudOf(1.0, 1, "raw", kFront), cloudInRobotFrame(1.0, 1, "on_robot", kFront)});
  EXPECT_THAT(selection.labels, ElementsAre("raw"));
  EXPECT_THAT(selection.notes, ElementsAre(HasSubstr("holds the returns of 'raw'")));
}

TEST_F(LidarSelectionTest, TakesDifferentReturnsOfOneTime) {
  EXPECT_THAT(select({cloudOf(1.0, 1, "a", kFront), cloudInRobotFrame(1.0, 2, "b", kFront)}).labels,
              ElementsAre("a", "b"));
}

TEST_F(LidarSelectionTest, LeavesOutSensorsOfFewReturnsAndFaultyOnes) {
  auto broken = cloudObservation(1.0, makeScan(0), "broken");
  broken->setAsExternalStorage(
      "nowhere.txt", mrpt::obs::CObservationPointCloud::ExternalStorageFormat::PlainTextFile);
  const auto selection =
      select({cloudOf(1.0, 1, "radar", kFront, 60), broken, cloudOf(1.0, 2, "rear", kRear)});
  EXPECT_THAT(selection.labels, ElementsAre("rear"));
  EXPECT_THAT(selection.notes, ElementsAre(HasSubstr("'radar' are left out, it has no scan of 200"),
                                           HasSubstr("'broken' are left out, it can't be read")));
}

TEST_F(LidarSelectionTest, FallsBackToTheFirstWhereNoneIsFit) {
  EXPECT_THAT(select({cloudOf(1.0, 1, "a", kFront, 60), cloudOf(1.0, 2, "b", kRear, 60)}).labels,
              IsEmpty());
}

/// Both sensors of a log whose poses are the robot's.
TEST(RawlogSourceOfSeveral, GivesEachScanItsOwnPoseAndCountsThemTogether) {
  const TemporaryFolder folder;
  const Eigen::Isometry3d robot = poseOf(3, 4, 1, 0.5);
  writeObjects(
      folder / "a.rawlog",
      {poseObservation(0.9, robot), poseObservation(1.2, robot), cloudOf(1.0, 1, "front", kFront),
       cloudOf(1.0, 2, "rear", kRear), cloudOf(1.1, 3, "other", kRear),
       cloudOf(1.1, 4, "rear", kRear), cloudOf(1.05, 5, "front", kFront)});
  InputOptions options;
  options.maxPoseGap = 1.0;
  options.sensorLabels = {"front", "rear"};
  const ReadInput read = readInput(folder / "a.rawlog", options);
  ASSERT_EQ(read.scans.size(), 4u);
  const char* labels[] = {"front", "rear", "rear", "front"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read.scans[i].index, i);
    EXPECT_EQ(read.scans[i].sensorLabel, labels[i]);
    const Eigen::Isometry3d& place = read.scans[i].sensorLabel == "front" ? kFront : kRear;
    EXPECT_TRUE(read.scans[i].mapFromSensor.isApprox(robot * place, 1e-9));
  }
  EXPECT_EQ(read.report.skippedForTime, 0u);
  EXPECT_THAT(read.report.warnings,
              ::testing::Contains(HasSubstr("labelled 'front', 'rear' are used")));
}

/// A pose file holds the poses of the first sensor; the others sit where the log says.
TEST(RawlogSourceOfSeveral, PutsTheOthersWhereTheySitBesideThePosedOne) {
  const TemporaryFolder folder;
  const Eigen::Isometry3d robot = poseOf(3, 4, 1, 0.5);
  const Eigen::Isometry3d front = robot * kFront;
  std::ofstream poses(folder / "front.tum");
  const Eigen::Quaterniond q(front.linear());
  poses.precision(17);
  for (const double time : {0.9, 1.2})
    poses << time << " " << front.translation().transpose() << " " << q.x() << " " << q.y() << " "
          << q.z() << " " << q.w() << "\n";
  poses.close();
  writeObjects(folder / "a.rawlog",
               {cloudOf(1.0, 1, "front", kFront), cloudOf(1.1, 2, "rear", kRear)});
  InputOptions options;
  options.maxPoseGap = 1.0;
  options.sensorLabels = {"front", "rear"};
  options.poseFile = (folder / "front.tum").string();
  const ReadInput read = readInput(folder / "a.rawlog", options);
  ASSERT_EQ(read.scans.size(), 2u);
  EXPECT_TRUE(read.scans[0].mapFromSensor.isApprox(front, 1e-9));
  EXPECT_TRUE(read.scans[1].mapFromSensor.isApprox(robot * kRear, 1e-9));
}

}  // namespace
}  // namespace toss::test
