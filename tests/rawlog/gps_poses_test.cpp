// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationGPS.h>
#include <toss/rawlog/InputSummary.h>

#include <cmath>

#include "InputFixtures.h"

namespace toss::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Metres of a degree of latitude and longitude on the equator of WGS 84.
constexpr double kLatitudeDegree = 110574.276, kLongitudeDegree = 111319.491;
constexpr double kRadius = 40.0, kSpeed = 8.0, kStart = 1.6e9, kStanding = 2.0;
const Eigen::Vector3d kAntenna(0.5, 0.2, 1.5);

/// Where the robot is that stands and then drives a circle to the left, north first.
Eigen::Isometry3d robotAt(double seconds) {
  const double angle = kSpeed / kRadius * std::max(0.0, seconds - kStanding);
  return poseOf(kRadius * (std::cos(angle) - 1.0), kRadius * std::sin(angle), 0.0,
                angle + 0.5 * M_PI);
}

Object fixOf(double seconds, const Eigen::Vector3d& antenna, bool valid = true) {
  auto gps = mrpt::obs::CObservationGPS::Create();
  gps->timestamp = toMrptTime(kStart + seconds);
  gps->sensorPose = mrpt::poses::CPose3D(kAntenna.x(), kAntenna.y(), kAntenna.z(), 0, 0, 0);
  mrpt::obs::gnss::Message_NMEA_GGA message;
  message.fields.latitude_degrees = antenna.y() / kLatitudeDegree;
  message.fields.longitude_degrees = antenna.x() / kLongitudeDegree;
  message.fields.altitude_meters = 100.0 + antenna.z();
  message.fields.fix_quality = valid ? 1 : 0;
  gps->setMsg(message);
  return gps;
}

/// Fixes and scans at 10 Hz.
std::vector<Object> drive(double seconds) {
  std::vector<Object> objects;
  for (int i = 0; i * 0.1 < seconds; ++i) {
    objects.push_back(fixOf(0.1 * i, robotAt(0.1 * i) * kAntenna));
    objects.push_back(cloudObservation(kStart + 0.1 * i, makeScan(static_cast<unsigned>(i))));
  }
  return objects;
}

InputOptions byGps() {
  InputOptions options;
  options.poseSource = PoseSource::Gps;
  return options;
}

TEST(GpsPoses, FollowThePathAndLookAlongIt) {
  const TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", drive(20.0));
  const ReadInput read = readInput(folder / "a.rawlog", byGps());
  ASSERT_EQ(read.scans.size(), 200u);
  // The map begins with the first fix of the antenna.
  const Eigen::Vector3d origin = robotAt(0.0) * kAntenna;
  for (std::size_t i = 0; i < 200; ++i) {
    const Eigen::Isometry3d expected = robotAt(0.1 * static_cast<double>(i));
    const Eigen::Isometry3d& found = read.scans[i].mapFromSensor;
    EXPECT_LT((found.translation() - (expected.translation() - origin)).norm(), 0.08) << i;
    const Eigen::Matrix3d turn = found.linear().transpose() * expected.linear();
    // At the end the course is that of a stretch which may lie 3 m back.
    EXPECT_LT(Eigen::AngleAxisd(turn).angle(), i < 190 ? 0.06 : 4.5 / kRadius) << i;
    EXPECT_NEAR(found.linear()(2, 2), 1.0, 1e-12);
  }
  EXPECT_THAT(read.report.warnings, Contains(HasSubstr("good to metres at best")));
}

TEST(GpsPoses, KeepTheHeadingWhileTheRobotStands) {
  const TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", drive(8.0));
  const ReadInput read = readInput(folder / "a.rawlog", byGps());
  for (std::size_t i = 1; i < 20; ++i)
    EXPECT_TRUE(read.scans.at(i).mapFromSensor.isApprox(read.scans[0].mapFromSensor, 1e-9)) << i;
}

TEST(GpsPoses, AreRefusedWhereTheMotionIsTooSmall) {
  const TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", drive(2.6));
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "a.rawlog", byGps()); }),
              HasSubstr("less than 6 m of way"));
  std::vector<Object> blind = logOf(2);
  blind.push_back(fixOf(0.0, {0, 0, 0}, false));
  writeObjects(folder / "b.rawlog", blind);
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "b.rawlog", byGps()); }),
              HasSubstr("no CObservationGPS with a position"));
}

TEST(GpsPoses, AreTakenOnlyWhenAskedFor) {
  const TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", drive(10.0));
  const std::string complaint = userErrorOf([&] { readInput(folder / "a.rawlog"); });
  EXPECT_THAT(complaint, HasSubstr("only GPS positions"));
  EXPECT_THAT(complaint, HasSubstr("input.pose_source=gps"));
  EXPECT_THAT(complaint, HasSubstr("--poses FILE"));
  EXPECT_THAT(complaint, HasSubstr("--odometry"));
  EXPECT_EQ(summarizeInput(folder / "a.rawlog").poses, 0u);
  EXPECT_EQ(summarizeInput(folder / "a.rawlog", byGps()).poses, 100u);
}

}  // namespace
}  // namespace toss::test
