// SPDX-License-Identifier: BSD-3-Clause
// ROS 1 bags by way of MRPT's rosbag2rawlog (Debian package mrpt-apps): share/doc/from-ros-bag.md.
#include <mrpt/maps/CSimplePointsMap.h>
#include <toss/rawlog/PlyFile.h>

#include "CrossingLog.h"
#include "RosBag.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// sensor_msgs/PointCloud2 as the drivers of Velodyne leave it: x y z intensity ring time.
RosBytes pointCloud2(const PosedScan& scan) {
  constexpr std::uint8_t kUint16 = 4, kFloat = 7;
  constexpr std::uint32_t kStep = 22;
  const auto count = static_cast<std::uint32_t>(scan.points.size());
  RosBytes message;
  message.addHeader(scan.time, "velodyne").add(std::uint32_t{1}).add(count).add(std::uint32_t{6});
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "intensity", "ring", "time"}) {
    const bool isRing = std::string(name) == "ring";
    message.addText(name).add(offset).add(isRing ? kUint16 : kFloat).add(std::uint32_t{1});
    offset += isRing ? 2 : 4;
  }
  message.add(std::uint8_t{0}).add(kStep).add(kStep * count).add(kStep * count);
  for (std::size_t i = 0; i < count; ++i)
    message.add(scan.points.x[i])
        .add(scan.points.y[i])
        .add(scan.points.z[i])
        .add(100.0f)
        .add(std::uint16_t{3})
        .add(0.01f);
  return message.add(std::uint8_t{0});
}

/// tf2_msgs/TFMessage with the pose of the sensor in the map.
RosBytes transform(const PosedScan& scan) {
  const Eigen::Vector3d at = scan.mapFromSensor.translation();
  const Eigen::Quaterniond turn(scan.mapFromSensor.linear());
  RosBytes message;
  message.add(std::uint32_t{1}).addHeader(scan.time, "map").addText("velodyne");
  for (const double number : {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()})
    message.add(number);
  return message;
}

/// MRPT's buffers are aligned otherwise than those of scans.
std::vector<float> toVector(const mrpt::aligned_std_vector<float>& buffer) {
  return {buffer.begin(), buffer.end()};
}

class RosBags : public CrossingLog {
 protected:
  void SetUp() override {
    if (std::system("command -v rosbag2rawlog >/dev/null") != 0)
      GTEST_SKIP() << "rosbag2rawlog is not installed (package mrpt-apps)";
    if (!scans_.empty()) return;
    InputOptions asRecorded;
    asRecorded.deskew = Deskew::Off;
    scans_ = readInput(rawlog(), asRecorded).scans;
    RosBag bag;
    bag.addTopic("/tf", "tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec");
    bag.addTopic("/velodyne_points", "sensor_msgs/PointCloud2", "1158d486dd51d683ce2f1be655c3c181");
    for (const PosedScan& scan : scans_) {
      bag.add("/tf", scan.time, transform(scan));
      bag.add("/velodyne_points", scan.time, pointCloud2(scan));
    }
    bag.write(in("a.bag"));
    convert("/velodyne_points", "a.rawlog");
  }
  static void TearDownTestSuite() {
    scans_.clear();
    CrossingLog::TearDownTestSuite();
  }

  static void convert(const std::string& topic, const std::string& to) {
    writeBytes(
        in("lidar.yml"),
        "sensors:\n  lidar:\n    type: 'CObservationPointCloud'\n    topic: '" + topic + "'\n");
    runTool("rosbag2rawlog -w -f map -c " + quoted(in("lidar.yml")) + " -o " + quoted(in(to)) +
            " " + quoted(in("a.bag")));
  }
  static void runTool(const std::string& command) {
    EXPECT_EQ(std::system((command + " >" + quoted(in("said")) + " 2>&1").c_str()), 0)
        << readBytes(in("said"));
  }
  /// The objects of a converted log, and the poses of a robot that has the sensor at that place.
  static std::vector<Object> withPoses(const std::string& log,
                                       const Eigen::Isometry3d& robotFromSensor) {
    std::vector<Object> objects = objectsOf(in(log));
    for (const PosedScan& scan : scans_)
      objects.push_back(poseObservation(scan.time, scan.mapFromSensor * robotFromSensor.inverse()));
    return objects;
  }

  static inline std::vector<PosedScan> scans_;
};

TEST_F(RosBags, KeepScansTimesAndPointsButNoIntensities) {
  const std::vector<Object> objects = objectsOf(in("a.rawlog"));
  ASSERT_EQ(objects.size(), kScans);
  for (std::size_t i = 0; i < kScans; ++i) {
    const auto cloud = std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(objects[i]);
    ASSERT_TRUE(cloud) << "object " << i;
    const mrpt::maps::CPointsMap& points = *cloud->pointcloud;
    EXPECT_TRUE(IS_CLASS(points, mrpt::maps::CSimplePointsMap));
    EXPECT_NEAR(fromMrptTime(cloud->timestamp), scans_[i].time, 1e-6);
    EXPECT_TRUE(sameBits(toVector(points.getPointsBufferRef_x()), scans_[i].points.x));
    EXPECT_TRUE(sameBits(toVector(points.getPointsBufferRef_y()), scans_[i].points.y));
    EXPECT_TRUE(sameBits(toVector(points.getPointsBufferRef_z()), scans_[i].points.z));
  }
}

TEST_F(RosBags, LoseThePosesOfTf) {
  EXPECT_THAT(complaintOf("map " + quoted(in("a.rawlog")) + " --out " + quoted(in("none"))),
              HasSubstr("no poses"));
  EXPECT_FALSE(fs::exists(in("none")));
}

TEST_F(RosBags, AreMappedLikeTheLogItselfOnceTheyHavePoses) {
  writeObjects(in("posed.rawlog"), withPoses("a.rawlog", Eigen::Isometry3d::Identity()));
  const std::string options = "--no-snapshots --set input.deskew=off";
  const fs::path posed = map(in("posed.rawlog"), "posed", options),
                 direct = map(rawlog(), "direct", options);
  const auto labels = filesIn(posed / "labels");
  EXPECT_EQ(labels.size(), kScans);
  EXPECT_TRUE(labels == filesIn(direct / "labels"));
  const auto points = readPointCloudFile(posed / "static_map.ply").size();
  EXPECT_GT(points, 10'000u);
  EXPECT_EQ(points, readPointCloudFile(direct / "static_map.ply").size());
}

TEST_F(RosBags, TakeThePlaceOfTheSensorOnTheRobotFromRawlogEdit) {
  writeBytes(in("mount.ini"),
             "[lidar]\nsensorLabel = lidar\npose_x = 1.5\npose_y = 0\npose_z = 2\n"
             "pose_yaw = 90\npose_pitch = 0\npose_roll = 0\n");
  runTool("rawlog-edit -w --sensors-pose " + quoted(in("mount.ini")) + " -i " +
          quoted(in("a.rawlog")) + " -o " + quoted(in("mounted.rawlog")));
  const Eigen::Isometry3d robotFromSensor = poseOf(1.5, 0, 2, M_PI / 2);
  writeObjects(in("robot.rawlog"), withPoses("mounted.rawlog", robotFromSensor));
  const ReadInput read = readInput(in("robot.rawlog"));
  ASSERT_EQ(read.scans.size(), kScans);
  for (std::size_t i = 0; i < kScans; ++i)
    EXPECT_LT((read.scans[i].mapFromSensor.matrix() - scans_[i].mapFromSensor.matrix()).norm(),
              1e-6)
        << i;
}

TEST_F(RosBags, OfAnotherTopicAreToldToHoldNothing) {
  convert("/points", "empty.rawlog");
  EXPECT_THAT(readBytes(in("said")), HasSubstr("unhandled topic '/velodyne_points'"));
  EXPECT_THAT(complaintOf("map " + quoted(in("empty.rawlog")) + " --out " + quoted(in("none"))),
              HasSubstr("no MRPT object"));
}

}  // namespace
}  // namespace toss::test
