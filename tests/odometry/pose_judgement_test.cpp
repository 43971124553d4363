// SPDX-License-Identifier: BSD-3-Clause
// Faults put into the poses of a drive whose true motion is known in closed form.
#include <InputFixtures.h>
#include <toss/odometry/PoseJudgement.h>

#include <cmath>
#include <functional>

namespace toss::test {
namespace {

using Pose = Eigen::Isometry3d;

/// A drive with changing speed and turns, at any time [s].
Pose drive(double t) {
  const double yaw = 0.4 * std::sin(0.6 * t), pitch = 0.02 * std::sin(1.3 * t);
  return poseOf(6.0 * t + 3.0 * std::sin(0.9 * t), 2.0 * std::sin(0.6 * t), 0.1 * t, yaw, pitch);
}

/// 60 scans at 10 Hz; the scans are right, the poses are what `given` makes of the time.
PoseJudgement judge(const std::function<Pose(double)>& given,
                    const std::function<Pose(double)>& truth = drive, double givenFit = 0.5) {
  MotionStretch stretch;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1 * i;
    stretch.times.push_back(100.0 + t);
    stretch.found.push_back(truth(0.0).inverse() * truth(t));
    stretch.given.push_back(given(t));
  }
  stretch.foundFit = 1.0, stretch.givenFit = givenFit;
  return judgePoses({stretch});
}

TEST(PoseJudgement, AcceptsPosesOfAnyMapFrameWithSmallErrors) {
  EXPECT_EQ(judge(drive).fault, PoseFault::None);
  const Pose map = poseOf(1e5, -2e5, 30, 2, 0.3, -1);
  const PoseJudgement noisy = judge([&](double t) {
    return map * drive(t) * poseOf(0.02 * std::sin(70 * t), 0.02 * std::cos(50 * t), 0, 0.001);
  });
  EXPECT_EQ(noisy.fault, PoseFault::None);
  EXPECT_LT(noisy.error, 0.1);
}

TEST(PoseJudgement, TrustsPosesUnderWhichTheScansAreAsSharp) {
  const auto still = [](double) { return Pose::Identity(); };
  EXPECT_EQ(judge(drive, still, 1.1).fault, PoseFault::None);
  EXPECT_NE(judge(drive, still, 0.8).fault, PoseFault::None);
}

TEST(PoseJudgement, SaysNothingWhereNothingMoves) {
  const auto still = [](double) { return Pose::Identity(); };
  EXPECT_EQ(judge(still, still).fault, PoseFault::Unknown);
  EXPECT_EQ(judgePoses({}).fault, PoseFault::Unknown);
}

TEST(PoseJudgement, FindsPosesThatStandStill) {
  EXPECT_EQ(judge([](double) { return poseOf(5, 6, 7, 1); }).fault, PoseFault::Still);
}

TEST(PoseJudgement, FindsInvertedPoses) {
  EXPECT_EQ(judge([](double t) { return drive(t).inverse(); }).fault, PoseFault::Inverted);
}

TEST(PoseJudgement, FindsPosesOfTheCamera) {
  Pose cameraFromLidar = Pose::Identity();
  cameraFromLidar.linear() << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  cameraFromLidar.translation() << 0.02, -0.06, -0.33;
  const PoseJudgement found =
      judge([&](double t) { return cameraFromLidar * drive(t) * cameraFromLidar.inverse(); });
  EXPECT_EQ(found.fault, PoseFault::CameraAxes);
  EXPECT_LT(found.mendedError, 0.3 * found.error);
}

TEST(PoseJudgement, FindsTheUnit) {
  const PoseJudgement found = judge([](double t) {
    Pose pose = drive(t);
    pose.translation() *= 1000.0;
    return pose;
  });
  EXPECT_EQ(found.fault, PoseFault::Scale);
  EXPECT_NEAR(found.scale, 0.001, 1e-5);
}

TEST(PoseJudgement, FindsTheOffsetInTime) {
  for (const double offset : {-0.6, -0.3, 0.4}) {
    const PoseJudgement found = judge([&](double t) { return drive(t - offset); });
    EXPECT_EQ(found.fault, PoseFault::TimeOffset) << offset;
    EXPECT_NEAR(found.timeOffset, offset, 0.021);
  }
}

TEST(PoseJudgement, FindsWhereTheSensorSits) {
  const Pose robotFromSensor = poseOf(1.5, -0.4, 0, 1.2, 0.3);
  const PoseJudgement found = judge([&](double t) { return drive(t) * robotFromSensor.inverse(); });
  EXPECT_EQ(found.fault, PoseFault::Displaced);
  const Pose error = found.poseFromSensor.inverse() * robotFromSensor;
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), 0.02);
  EXPECT_LT(error.translation().head<2>().norm(), 0.2);
}

TEST(PoseJudgement, NamesNoCauseWhereNoneExplainsTheError) {
  const PoseJudgement found = judge([](double t) {
    return poseOf(5.0 * std::sin(3.1 * t), 4.0 * std::cos(2.3 * t), 0.5 * t, 2.0 * std::sin(t * t));
  });
  EXPECT_EQ(found.fault, PoseFault::Inconsistent);
}

}  // namespace
}  // namespace toss::test
