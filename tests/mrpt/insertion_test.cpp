// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <array>
#include <map>
#include <utility>

#include "MapFixtures.h"

namespace toss::test {
namespace {

TEST(MrptMap, IsWhatThePipelineMakesOfTheSameScans) {
  CDynamicFilteredPointsMap map;
  map.insertionOptions = vlp16();
  insertScans(map, 0, crossing().size());
  map.finish();
  EXPECT_TRUE(sameMap(pointsOf(map.points()), directMap(0, crossing().size())));
}

TEST(MrptMap, HonoursThePoseOfTheSensorOnTheRobot) {
  const Eigen::Isometry3d robotFromSensor = toss::test::poseOf(0.4, -0.2, 1.7, 0.6, 0.1, -0.05);
  CDynamicFilteredPointsMap map;
  map.insertionOptions = vlp16();
  for (const SimulatedScan& each : crossing()) {
    auto observation = cloudObservation(1.6e9 + each.scan.time, each.scan);
    observation->sensorPose = toMrpt(robotFromSensor);
    const auto robot = toMrpt(each.scan.mapFromSensor * robotFromSensor.inverse());
    EXPECT_TRUE(map.insertObservation(*observation, robot));
  }
  map.finish();
  const std::vector<MapPoint> expected = directMap(0, crossing().size());
  ASSERT_NEAR(static_cast<double>(map.points().size()), static_cast<double>(expected.size()),
              0.002 * static_cast<double>(expected.size()));
  std::size_t near = 0;
  for (const MapPoint& point : expected) {
    float squared = 0.0f;
    map.points().kdTreeClosestPoint3D(point.x, point.y, point.z, squared);
    near += squared < 1e-4f;
  }
  EXPECT_GT(near, expected.size() * 99 / 100);
}

/// One turn of a VLP-16 inside a cylinder of 10 m radius.
mrpt::obs::CObservationVelodyneScan velodyneTurn() {
  using Scan = mrpt::obs::CObservationVelodyneScan;
  Scan scan;
  scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
  scan.timestamp = toMrptTime(1.6e9);
  scan.sensorLabel = "velodyne";
  for (int rotation = 0; rotation < 36000; rotation += 12 * 40) {
    std::string bytes;
    const auto add = [&](int value) {
      bytes += {static_cast<char>(value & 0xff), static_cast<char>(value >> 8)};
    };
    for (int block = 0; block < 12; ++block) {
      add(Scan::UPPER_BANK);
      add((rotation + block * 40) % 36000);
      for (int laser = 0; laser < 32; ++laser, bytes += ' ') add(5000);
    }
    bytes += std::string(4, '\0') + "\x37\x22";
    Scan::TVelodyneRawPacket packet;
    EXPECT_EQ(bytes.size(), sizeof packet);
    std::memcpy(static_cast<void*>(&packet), bytes.data(), sizeof packet);
    scan.scan_packets.push_back(packet);
  }
  return scan;
}

TEST(MrptMap, PlacesVelodynePacketsByTheirPose) {
  const auto pointsFrom = [](const mrpt::poses::CPose3D& pose) {
    CDynamicFilteredPointsMap map;
    map.insertionOptions.settings = {"map.voxel_size=0", "map.keep_below_ground=true"};
    EXPECT_TRUE(map.insertObservation(velodyneTurn(), pose));
    return pointsOf(map.points());
  };
  const Eigen::Isometry3d moved = toss::test::poseOf(30.0, -20.0, 5.0, 0.0);
  const std::vector<MapPoint> here = pointsFrom(mrpt::poses::CPose3D());
  const std::vector<MapPoint> there = pointsFrom(toMrpt(moved));
  ASSERT_GT(here.size(), 5000u);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_NEAR(std::hypot(here[i].x, here[i].y, here[i].z), 10.0f, 0.2f);
    EXPECT_NEAR(there[i].x - here[i].x, 30.0f, 1e-4f);
    EXPECT_NEAR(there[i].y - here[i].y, -20.0f, 1e-4f);
    EXPECT_NEAR(there[i].z - here[i].z, 5.0f, 1e-4f);
  }
}

TEST(MrptMap, TakesTheOriginWhereNoPoseIsGiven) {
  CDynamicFilteredPointsMap with, without;
  with.insertionOptions = without.insertionOptions = vlp16();
  const auto observation = cloudObservation(1.6e9, crossing().front().scan);
  EXPECT_TRUE(with.insertObservation(*observation, mrpt::poses::CPose3D()));
  EXPECT_TRUE(without.insertObservation(*observation));
  EXPECT_TRUE(sameMap(pointsOf(with.points()), pointsOf(without.points())));
}

TEST(MrptMap, RefusesWhatItCanNotUse) {
  CDynamicFilteredPointsMap map;
  map.insertionOptions = vlp16();
  const PosedScan& scan = crossing().front().scan;
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservation2DRangeScan()));
  auto timeless = cloudObservation(1.6e9, scan);
  timeless->timestamp = INVALID_TIMESTAMP;
  EXPECT_FALSE(map.insertObservation(*timeless));
  EXPECT_TRUE(map.isEmpty());
  EXPECT_TRUE(map.insertObservation(*cloudObservation(1.6e9, scan)));
  EXPECT_FALSE(map.insertObservation(*cloudObservation(1.6e9, scan)));
  EXPECT_FALSE(map.insertObservation(*cloudObservation(1.6e9 + 1.0, scan, "other")));
  EXPECT_TRUE(map.insertObservation(*cloudObservation(1.6e9 + 1.0, scan)));
}

TEST(MrptMap, TakesTheSensorThatIsAskedFor) {
  CDynamicFilteredPointsMap map;
  map.insertionOptions = vlp16();
  map.insertionOptions.settings.push_back("plugin.sensor_label=roof");
  const PosedScan& scan = crossing().front().scan;
  EXPECT_FALSE(map.insertObservation(*cloudObservation(1.6e9, scan, "bumper")));
  EXPECT_TRUE(map.insertObservation(*cloudObservation(1.6e9, scan, "roof")));
}

/// Another LiDAR, 0.5 m beside the first, whose scans come in between and hold other returns.
TEST(MrptMap, HoldsWhatSeveralLidarsSee) {
  const Eigen::Isometry3d beside = toss::test::poseOf(0.0, 0.5, 0.0, 0.0);
  CDynamicFilteredPointsMap one, both;
  one.insertionOptions = both.insertionOptions = vlp16();
  for (const SimulatedScan& each : crossing()) {
    const auto left = cloudObservation(1.6e9 + each.scan.time, each.scan, "left");
    auto right = cloudObservation(1.6e9 + each.scan.time, each.scan, "right");
    right->sensorPose = toMrpt(beside);
    const auto robot = toMrpt(each.scan.mapFromSensor);
    EXPECT_TRUE(one.insertObservation(*left, robot));
    EXPECT_TRUE(both.insertObservation(*left, robot));
    EXPECT_TRUE(both.insertObservation(*right, robot));
  }
  one.finish(), both.finish();
  EXPECT_GT(both.points().size(), one.points().size() * 3 / 2);
  // Each point of the first is there again, shifted.
  std::size_t shifted = 0;
  for (const MapPoint& point : pointsOf(one.points())) {
    float squared = 0.0f;
    both.points().kdTreeClosestPoint3D(point.x, point.y + 0.5f, point.z, squared);
    shifted += squared < 0.1f * 0.1f;
  }
  EXPECT_GT(shifted, one.points().size() * 99 / 100);
}

TEST(MrptMap, SaysWhereAnExternalCloudIsMissing) {
  CDynamicFilteredPointsMap map;
  auto observation = mrpt::obs::CObservationPointCloud::Create();
  observation->timestamp = toMrptTime(1.6e9);
  observation->sensorLabel = "roof";
  using Format = mrpt::obs::CObservationPointCloud::ExternalStorageFormat;
  observation->setAsExternalStorage("missing.bin", Format::KittiBinFile);
  const std::string complaint = userErrorOf([&] { map.insertObservation(*observation); });
  EXPECT_THAT(complaint, ::testing::HasSubstr("plugin.rawlog"));
  EXPECT_THAT(complaint, ::testing::HasSubstr("roof"));
}

/// Points of the map in cells of 0.2 m that hold returns of movers of the first scans and nothing
/// else, and the number of such cells.
std::pair<std::size_t, std::size_t> moverCells(const std::vector<MapPoint>& points,
                                               std::size_t scans) {
  std::map<std::array<int, 3>, std::array<std::size_t, 2>> returns;
  const auto cellOf = [](const Eigen::Vector3d& p) {
    return std::array<int, 3>{int(std::floor(p.x() * 5)), int(std::floor(p.y() * 5)),
                              int(std::floor(p.z() * 5))};
  };
  for (std::size_t s = 0; s < scans; ++s) {
    const SimulatedScan& each = crossing()[s];
    for (std::size_t i = 0; i < each.labels.size(); ++i) {
      const PointCloud& p = each.scan.points;
      const Eigen::Vector3d at = each.scan.mapFromSensor * Eigen::Vector3d(p.x[i], p.y[i], p.z[i]);
      ++returns[cellOf(at)][(each.labels[i] & 0xffffu) >= 252 ? 1 : 0];
    }
  }
  std::size_t cells = 0, inMap = 0;
  for (const auto& [cell, counts] : returns) cells += counts[0] == 0 && counts[1] > 0;
  for (const MapPoint& p : points)
    if (const auto found = returns.find(cellOf({p.x, p.y, p.z})); found != returns.end())
      inMap += found->second[0] == 0 && found->second[1] > 0;
  return {inMap, cells};
}

TEST(MrptMap, LeavesOutWhatMovesAlsoBeforeTheEnd) {
  CDynamicFilteredPointsMap map;
  map.insertionOptions = vlp16();
  map.insertionOptions.settings.push_back("plugin.refresh_scans=1");
  insertScans(map, 0, crossing().size());
  const auto [inMap, cells] = moverCells(pointsOf(map.points()), crossing().size());
  ASSERT_GT(cells, 100u);
  // Unfiltered, each of these cells holds more than two points.
  EXPECT_LT(inMap, cells / 2);
}

}  // namespace
}  // namespace toss::test
