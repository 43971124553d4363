// SPDX-License-Identifier: BSD-3-Clause
// How scans of a rawlog get their poses.
#include <InputFixtures.h>

namespace toss::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

Object cloudAt(double time) {
  return cloudObservation(time, makeScan(0));
}
Object poseAt(double time, double x, double yaw = 0.0) {
  return poseObservation(time, poseOf(x, 2.0 * x, 0.0, yaw));
}

TEST(RawlogPoses, InterpolatesBetweenThePosesAroundAScan) {
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog",
               {poseAt(1.0, 10.0, 3.0), cloudAt(1.025), poseAt(1.1, 14.0, 3.4)});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  // A quarter of the way; the yaw goes through pi the short way.
  EXPECT_TRUE(read.scans[0].mapFromSensor.isApprox(poseOf(11.0, 22.0, 0.0, 3.1), 1e-9));
}

TEST(RawlogPoses, FindsPosesThatComeLaterInTheLog) {
  TemporaryFolder folder;
  std::vector<Object> objects;
  for (int i = 0; i < 10; ++i) objects.push_back(cloudAt(1.0 + 0.1 * i));
  for (int i = 0; i < 10; ++i) objects.push_back(poseAt(1.0 + 0.1 * i, i));
  writeObjects(folder / "a.rawlog", objects);
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 10u);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(read.scans[static_cast<std::size_t>(i)].mapFromSensor.translation().x(), i);
}

TEST(RawlogPoses, TellsWhenPosesComeTooLate) {
  TemporaryFolder folder;
  std::vector<Object> objects;
  for (int i = 0; i < 10; ++i) objects.push_back(cloudAt(1.0 + 0.1 * i));
  for (int i = 0; i < 10; ++i) objects.push_back(poseAt(1.0 + 0.1 * i, i));
  writeObjects(folder / "a.rawlog", objects);
  InputOptions options;
  options.lookAhead = 4;
  const ReadInput read = readInput(folder / "a.rawlog", options);
  EXPECT_EQ(read.scans.size(), 4u);
  EXPECT_EQ(read.report.skippedForPose, 6u);
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("raise input.look_ahead")));
}

TEST(RawlogPoses, SkipsAndCountsScansWithoutAPoseNearEnough) {
  TemporaryFolder folder;
  // Before the first pose; near poses; in a gap of 1 s; after the last pose.
  writeObjects(folder / "a.rawlog", {cloudAt(0.9), poseAt(1.0, 0), cloudAt(1.05), poseAt(1.1, 1),
                                     cloudAt(1.6), poseAt(2.1, 2), cloudAt(2.1), cloudAt(2.12)});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 2u);
  EXPECT_EQ(read.scans[0].index, 1u);
  EXPECT_EQ(read.scans[1].index, 3u);
  EXPECT_EQ(read.report.skippedForPose, 3u);
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("3 scans were skipped")));

  InputOptions options;
  options.maxPoseGap = 0.6;
  EXPECT_EQ(readInput(folder / "a.rawlog", options).scans.size(), 3u);
}

TEST(RawlogPoses, ShiftsTheClockOfTheScans) {
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", {poseAt(100.0, 7.0), cloudAt(40.0)});
  InputOptions options;
  options.timeOffset = 60.0;
  const ReadInput read = readInput(folder / "a.rawlog", options);
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_EQ(read.scans[0].mapFromSensor.translation().x(), 7.0);
  EXPECT_EQ(read.scans[0].time, 40.0);
}

TEST(RawlogPoses, UsesOneSourceOfPoses) {
  TemporaryFolder folder;
  auto other = poseObservation(1.0, poseOf(99, 0, 0, 0));
  other->sensorLabel = "gps";
  writeObjects(folder / "a.rawlog", {poseAt(1.0, 3.0), other, cloudAt(1.0)});
  const ReadInput read = readInput(folder / "a.rawlog");
  EXPECT_EQ(read.scans.at(0).mapFromSensor.translation().x(), 3.0);
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("input.pose_label")));
  InputOptions options;
  options.poseLabel = "gps";
  EXPECT_EQ(readInput(folder / "a.rawlog", options).scans.at(0).mapFromSensor.translation().x(),
            99.0);
}

TEST(RawlogPoses, LeavesOutPosesThatAreNone) {
  TemporaryFolder folder;
  Eigen::Isometry3d notFinite = poseOf(0, 0, 0, 0), sheared = poseOf(0, 0, 0, 0);
  notFinite(0, 3) = std::numeric_limits<double>::quiet_NaN();
  sheared(0, 1) = 0.5;
  writeObjects(folder / "a.rawlog",
               {poseAt(1.0, 0), poseObservation(1.05, notFinite), poseObservation(1.05, sheared),
                poseAt(1.1, 2), cloudAt(1.05)});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  EXPECT_NEAR(read.scans[0].mapFromSensor.translation().x(), 1.0, 1e-9);
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("2 poses are not finite")));
}

TEST(RawlogPoses, ExplainsALogWithoutUsablePoses) {
  TemporaryFolder folder;
  writeObjects(folder / "none.rawlog", {cloudAt(1.0), cloudAt(1.1)});
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "none.rawlog"); }),
              HasSubstr("holds no poses of the robot"));
  writeObjects(folder / "apart.rawlog", {cloudAt(1.0), poseAt(50.0, 0), poseAt(60.0, 1)});
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "apart.rawlog"); }),
              HasSubstr("scans from 1.000 s to 1.000 s, poses from 50.000 s to 60.000 s"));
  writeObjects(folder / "noclouds.rawlog", {poseAt(50.0, 0), poseAt(60.0, 1)});
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "noclouds.rawlog"); }),
              HasSubstr("holds no point cloud"));
}

TEST(RawlogPoses, SkipsScansThatGoBackInTime) {
  TemporaryFolder folder;
  std::vector<Object> objects;
  for (int i = 0; i < 5; ++i) objects.push_back(poseAt(1.0 + 0.1 * i, i));
  for (const double time : {1.0, 1.2, 1.1, 1.2, 1.3}) objects.push_back(cloudAt(time));
  auto timeless = cloudObservation(1.0, makeScan(0));
  timeless->timestamp = INVALID_TIMESTAMP;
  objects.push_back(timeless);
  writeObjects(folder / "a.rawlog", objects);
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 3u);
  EXPECT_EQ(read.scans[2].index, 4u);
  EXPECT_EQ(read.report.skippedForTime, 2u);
  EXPECT_THAT(read.report.warnings,
              Contains(HasSubstr("first at " + (folder / "a.rawlog").string() + ": object 7")));
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("1 scans were skipped, they have no time")));
}

}  // namespace
}  // namespace toss::test
