// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/MetricMapFile.h>
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/TracksCsv.h>

#include <nlohmann/json.hpp>
#include <set>

#include "CrossingLog.h"

namespace toss::test {
namespace {

using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRobotPose;

/// Every file that `toss map` promises, read by something other than what wrote it where MRPT or
/// a public format allows.
class Outputs : public CrossingLog {
 protected:
  static std::vector<std::uint32_t> labelsOf(const PosedScan& scan) {
    return readLabels(labelPath(run() / "labels", scan.index), scan.points.size());
  }
  static nlohmann::json summary() {
    return nlohmann::json::parse(readBytes(run() / "summary.json"));
  }
  static std::vector<Object> filteredObjects() { return objectsOf(run() / "filtered.rawlog"); }
};

std::uint64_t countOf(const std::vector<std::uint32_t>& labels, std::uint32_t semantic) {
  return static_cast<std::uint64_t>(
      std::count_if(labels.begin(), labels.end(),
                    [&](std::uint32_t value) { return label::semantic(value) == semantic; }));
}

TEST_F(Outputs, AllFilesOfTheContractAreThereAndNothingElse) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(run())) names.insert(entry.path().filename());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre(
                         "static_map.ply", "static_map.metricmap", "moving_points.ply", "labels",
                         "tracks.csv", "filtered.rawlog", "scene.3Dscene", "snapshots",
                         "summary.json", "timings.csv", "resources.json", "config.ini"));
}

TEST_F(Outputs, LabelsAreIndexAlignedAndHoldTheThreeClasses) {
  std::uint64_t invalid = 0, moving = 0, points = 0;
  for (const PosedScan& scan : readInput(rawlog()).scans) {
    const auto labels = labelsOf(scan);
    const auto still = countOf(labels, label::kStatic);
    invalid += countOf(labels, label::kInvalid), moving += countOf(labels, label::kMoving);
    points += labels.size();
    EXPECT_EQ(still + countOf(labels, label::kMoving) + countOf(labels, label::kInvalid),
              scan.points.size());
  }
  EXPECT_EQ(summary()["points"]["read"], points);
  EXPECT_EQ(summary()["points"]["invalid"], invalid);
  EXPECT_EQ(summary()["points"]["moving"], moving);
  EXPECT_EQ(filesIn(run() / "labels").size(), kScans);
}

TEST_F(Outputs, MovingPointsAreThoseOfTheLabelsInTheMapFrame) {
  std::vector<Eigen::Vector3d> expected;
  for (const PosedScan& scan : readInput(rawlog()).scans) {
    const auto labels = labelsOf(scan);
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (label::isMoving(labels[i]))
        expected.push_back(scan.mapFromSensor *
                           Eigen::Vector3d(scan.points.x[i], scan.points.y[i], scan.points.z[i]));
  }
  const auto points = readPointCloudFile(run() / "moving_points.ply");
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d point(points[i].x, points[i].y, points[i].z);
    EXPECT_LT((point - expected[i]).norm(), 1e-4);
  }
  EXPECT_NE(readBytes(run() / "moving_points.ply").find("property float track"), std::string::npos);
}

TEST_F(Outputs, PlyHeaderTellsFormatAndCount) {
  const std::string bytes = readBytes(run() / "static_map.ply");
  const std::string end = "end_header\n";
  const std::size_t body = bytes.find(end) + end.size();
  const std::string header = bytes.substr(0, body);
  EXPECT_EQ(header.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
  EXPECT_NE(header.find("property float x\nproperty float y\nproperty float z\n"
                        "property float intensity\n"),
            std::string::npos);
  const std::size_t count = summary()["points"]["static_map"];
  EXPECT_GT(count, 10000u);
  EXPECT_NE(header.find("element vertex " + std::to_string(count) + "\n"), std::string::npos);
  EXPECT_EQ(bytes.size() - body, count * 16);
}

TEST_F(Outputs, MetricMapHoldsTheSamePoints) {
  const auto ply = readPointCloudFile(run() / "static_map.ply");
  mrpt::io::CFileGZInputStream stream((run() / "static_map.metricmap").string());
  auto archive = mrpt::serialization::archiveFrom(stream);
  const auto map = archive.ReadObject<mrpt::maps::CPointsMapXYZI>();
  ASSERT_EQ(map->size(), ply.size());
  for (std::size_t i = 0; i < ply.size(); ++i) {
    float x, y, z;
    map->getPoint(i, x, y, z);
    EXPECT_TRUE(x == ply[i].x && y == ply[i].y && z == ply[i].z);
    EXPECT_EQ(map->getPointIntensity(i), ply[i].intensity);
  }
}

TEST_F(Outputs, TracksTellOfTheTwoMovers) {
  std::map<std::uint64_t, std::set<TrackId>> movingByScan;
  double fastest = 0.0;
  for (const TrackRow& row : readTracksCsv(run() / "tracks.csv")) {
    EXPECT_LT(row.scan, kScans);
    if (!row.sample.moving) continue;
    movingByScan[row.scan].insert(row.sample.track);
    fastest = std::max(fastest, row.sample.velocity.head<2>().norm());
  }
  EXPECT_GT(movingByScan.size(), kScans / 2);
  for (const auto& [scan, tracks] : movingByScan) EXPECT_LE(tracks.size(), 8u) << scan;
  EXPECT_GT(fastest, 2.0);
  EXPECT_LT(fastest, 30.0);
}

TEST_F(Outputs, FilteredRawlogHoldsEachReturnOnceWithPoseAndTime) {
  const auto objects = filteredObjects();
  const auto scans = readInput(rawlog()).scans;
  ASSERT_EQ(objects.size(), 3 * scans.size());
  for (std::size_t s = 0; s < scans.size(); ++s) {
    const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(objects[3 * s]);
    const auto still = std::dynamic_pointer_cast<CObservationPointCloud>(objects[3 * s + 1]);
    const auto moving = std::dynamic_pointer_cast<CObservationPointCloud>(objects[3 * s + 2]);
    ASSERT_TRUE(pose && still && moving);
    EXPECT_EQ(still->sensorLabel, "LIDAR_STATIC");
    EXPECT_EQ(moving->sensorLabel, "LIDAR_MOVING");
    EXPECT_EQ(pose->timestamp, toMrptTime(scans[s].time));
    EXPECT_EQ(still->timestamp, pose->timestamp);
    EXPECT_EQ(moving->timestamp, pose->timestamp);
    const auto labels = labelsOf(scans[s]);
    EXPECT_EQ(still->pointcloud->size(), countOf(labels, label::kStatic));
    EXPECT_EQ(moving->pointcloud->size(), countOf(labels, label::kMoving));
    EXPECT_LT((pose->pose.mean.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>().asEigen() -
               scans[s].mapFromSensor.matrix())
                  .norm(),
              1e-6);
  }
}

TEST_F(Outputs, SceneOpens) {
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile((run() / "scene.3Dscene").string()));
  EXPECT_GT(scene.viewportsCount(), 0u);
  EXPECT_TRUE(scene.getByName("toss_run"));
}

TEST_F(Outputs, SummaryTellsInputVersionAndOptions) {
  const auto json = summary();
  EXPECT_EQ(json["version"], TOSS_VERSION);
  EXPECT_EQ(json["input"]["name"], "crossing.rawlog");
  EXPECT_EQ(json["input"]["bytes"], fs::file_size(rawlog()));
  EXPECT_EQ(json["scans"]["mapped"], kScans);
  EXPECT_EQ(json["options"]["sensor"]["model"], "VLP-16");
}

TEST_F(Outputs, TimingsHaveARowPerScanAndAColumnPerStage) {
  std::istringstream lines(readBytes(run() / "timings.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("scan,projection_ms,", 0), 0u);
  EXPECT_EQ(line.substr(line.rfind(',')), ",rest_ms");
  const auto columns = std::count(line.begin(), line.end(), ',');
  std::uint64_t rows = 0;
  for (; std::getline(lines, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    EXPECT_EQ(line.rfind(std::to_string(rows) + ",", 0), 0u);
  }
  EXPECT_EQ(rows, kScans);
}

TEST_F(Outputs, SnapshotsArePictures) {
  const auto pictures = filesIn(run() / "snapshots");
  if (pictures.empty()) GTEST_SKIP() << "this machine can not draw";
  EXPECT_EQ(pictures.size(), 4u);
  for (const auto& [name, bytes] : pictures) EXPECT_EQ(bytes.rfind("\x89PNG", 0), 0u) << name;
}

}  // namespace
}  // namespace toss::test
