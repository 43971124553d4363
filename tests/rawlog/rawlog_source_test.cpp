// SPDX-License-Identifier: BSD-3-Clause
// Reading rawlogs that are as they should be, in all their forms.
#include <InputFixtures.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

namespace toss::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The scans that logOf() puts into a log.
void expectScansOfLog(const ReadInput& read, std::size_t count) {
  ASSERT_EQ(read.scans.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    expectSameScan(read.scans[i], makeScan(i));
    EXPECT_EQ(read.scans[i].index, i);
    EXPECT_EQ(read.scans[i].sensorLabel, "lidar");
  }
}

TEST(RawlogSource, ReadsPlainAndGz) {
  TemporaryFolder folder;
  for (const bool gz : {false, true}) {
    const fs::path file = folder / (gz ? "gz.rawlog" : "plain.rawlog");
    writeObjects(file, logOf(4), gz);
    const ReadInput read = readInput(file);
    expectScansOfLog(read, 4);
    EXPECT_EQ(read.report.scans, 4u);
    EXPECT_EQ(read.report.points, 200u);
    EXPECT_EQ(read.report.notFinite, 8u);
    EXPECT_THAT(read.report.warnings, IsEmpty());
  }
}

TEST(RawlogSource, ReadsConcatenatedGzMembers) {
  TemporaryFolder folder;
  auto objects = logOf(6);
  const std::vector<Object> first(objects.begin(), objects.begin() + 5);
  const std::vector<Object> second(objects.begin() + 5, objects.end());
  writeObjects(folder / "a", first, true);
  writeObjects(folder / "b", second, true);
  writeBytes(folder / "ab.rawlog", readBytes(folder / "a") + readBytes(folder / "b"));
  expectScansOfLog(readInput(folder / "ab.rawlog"), 6);
}

TEST(RawlogSource, ReadsSensoryFrames) {
  TemporaryFolder folder;
  std::vector<Object> objects;
  for (std::size_t i = 0; i < 3; ++i) {
    const PosedScan scan = makeScan(i);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    // The cloud before its pose: the order inside a frame must not matter.
    frame->insert(cloudObservation(scan.time, scan));
    frame->insert(poseObservation(scan.time, scan.mapFromSensor));
    objects.push_back(mrpt::obs::CActionCollection::Create());
    objects.push_back(frame);
  }
  writeObjects(folder / "frames.rawlog", objects);
  expectScansOfLog(readInput(folder / "frames.rawlog"), 3);
}

TEST(RawlogSource, ReadsALogThatIsOneObject) {
  TemporaryFolder folder;
  auto whole = mrpt::obs::CRawlog::Create();
  for (const auto& object : logOf(3)) whole->insert(object);
  writeObjects(folder / "whole.rawlog", {whole});
  expectScansOfLog(readInput(folder / "whole.rawlog"), 3);
}

TEST(RawlogSource, IgnoresWhatIsNeitherPoseNorScan) {
  TemporaryFolder folder;
  auto objects = logOf(2);
  objects.insert(objects.begin(), mrpt::obs::CObservationComment::Create());
  writeObjects(folder / "a.rawlog", objects);
  expectScansOfLog(readInput(folder / "a.rawlog"), 2);
}

TEST(RawlogSource, AddsUpIncrementsOnlyWhenAsked) {
  TemporaryFolder folder;
  const Eigen::Isometry3d step = poseOf(1.0, 0.2, 0.0, 0.1);
  std::vector<Object> objects;
  for (std::size_t i = 0; i < 3; ++i) {
    auto movement = mrpt::obs::CActionRobotMovement3D();
    movement.poseChange.mean = toMrpt(step);
    auto actions = mrpt::obs::CActionCollection::Create();
    actions->insert(movement);
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(cloudObservation(makeScan(i).time, makeScan(i)));
    objects.insert(objects.end(), {actions, frame});
  }
  writeObjects(folder / "odometry.rawlog", objects);
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "odometry.rawlog"); }),
              HasSubstr("input.pose_source=odometry"));

  InputOptions options;
  options.poseSource = PoseSource::Odometry;
  const ReadInput read = readInput(folder / "odometry.rawlog", options);
  ASSERT_EQ(read.scans.size(), 3u);
  EXPECT_TRUE(read.scans[2].mapFromSensor.isApprox(step * step * step, 1e-12));
}

TEST(RawlogSource, HonoursBothSensorPoses) {
  TemporaryFolder folder;
  const Eigen::Isometry3d mapFromRobot = poseOf(10, 20, 1, 0.7, 0.1, -0.2);
  const Eigen::Isometry3d robotFromMarker = poseOf(0.3, -0.1, 1.2, -0.4, 0.05);
  const Eigen::Isometry3d robotFromSensor = poseOf(0.5, 0.0, 1.7, 1.57, 0.0, 0.3);
  auto pose = poseObservation(5.0, mapFromRobot * robotFromMarker);
  pose->sensorPose = toMrpt(robotFromMarker);
  auto cloud = cloudObservation(5.0, makeScan(0));
  cloud->sensorPose = toMrpt(robotFromSensor);
  writeObjects(folder / "a.rawlog", {pose, cloud});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_TRUE(read.scans[0].mapFromSensor.isApprox(mapFromRobot * robotFromSensor, 1e-12));
  EXPECT_TRUE(read.scans[0].robotFromSensor.isApprox(robotFromSensor, 1e-15));
}

TEST(RawlogSource, ReadsMapsWithoutIntensity) {
  TemporaryFolder folder;
  auto cloud = cloudObservation(5.0, makeScan(0));
  auto map = mrpt::maps::CSimplePointsMap::Create();
  map->insertPoint(1.0f, 2.0f, 3.0f);
  cloud->pointcloud = map;
  writeObjects(folder / "a.rawlog", {poseObservation(5.0, poseOf(0, 0, 0, 0)), cloud});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_EQ(read.scans[0].points.size(), 1u);
  EXPECT_EQ(read.scans[0].points.z[0], 3.0f);
  EXPECT_TRUE(read.scans[0].points.intensity.empty());
}

TEST(RawlogSource, DeliversEmptyScans) {
  TemporaryFolder folder;
  auto cloud = cloudObservation(6.0, makeScan(0, 0));
  auto none = cloudObservation(7.0, makeScan(0));
  none->pointcloud.reset();
  writeObjects(folder / "a.rawlog", {poseObservation(6.0, poseOf(0, 0, 0, 0)), cloud,
                                     poseObservation(7.0, poseOf(0, 0, 0, 0)), none});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 2u);
  EXPECT_TRUE(read.scans[0].points.empty() && read.scans[1].points.empty());
  EXPECT_EQ(read.report.empty, 2u);
}

TEST(RawlogSource, ReadsOneSensorAndTellsOfOthers) {
  TemporaryFolder folder;
  const auto pose = poseObservation(1.0, poseOf(0, 0, 0, 0));
  writeObjects(folder / "a.rawlog", {pose, cloudObservation(1.0, makeScan(0), "front"),
                                     cloudObservation(1.0, makeScan(1), "rear")});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_EQ(read.scans[0].sensorLabel, "front");
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("1 of 'rear'")));

  InputOptions options;
  options.sensorLabel = "rear";
  EXPECT_EQ(readInput(folder / "a.rawlog", options).scans.at(0).sensorLabel, "rear");
  options.sensorLabel = "top";
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "a.rawlog", options); }),
              HasSubstr("no point cloud of sensor 'top', but 1 of 'front', 1 of 'rear'"));
}

}  // namespace
}  // namespace toss::test
