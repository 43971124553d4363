// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <toss/rawlog/FilteredRawlogWriter.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRobotPose;

/// Every third return moves; what is not valid has no state.
ScanLabels labelsOf(const PosedScan& scan) {
  ScanLabels labels;
  labels.scan = scan.index;
  labels.time = scan.time;
  labels.state.resize(scan.points.size(), PointState::Static);
  labels.track.resize(scan.points.size(), 0);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (i % 3 == 0) labels.state[i] = PointState::Moving;
    if (i >= 2 && i <= 4) labels.state[i] = PointState::Invalid;
  }
  return labels;
}

PosedScan scanOnRobot(std::uint64_t index) {
  PosedScan scan = makeScan(index);
  scan.robotFromSensor = poseOf(0.4, -0.1, 1.7, 0.2, 0.05, -0.02);
  return scan;
}

std::vector<Object> readAll(const fs::path& file) {
  mrpt::io::CFileGZInputStream stream(file.string());
  auto archive = mrpt::serialization::archiveFrom(stream);
  std::vector<Object> objects;
  try {
    for (;;) objects.push_back(archive.ReadObject());
  } catch (const mrpt::serialization::CExceptionEOF&) {
    return objects;
  }
}

void expectCloud(const Object& object, const PosedScan& scan, const ScanLabels& labels,
                 PointState state, const std::string& label) {
  const auto cloud = std::dynamic_pointer_cast<CObservationPointCloud>(object);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->sensorLabel, label);
  EXPECT_NEAR(fromMrptTime(cloud->timestamp), scan.time, 1e-7);
  EXPECT_TRUE(fromMrpt(cloud->sensorPose).isApprox(scan.robotFromSensor, 1e-12));
  const auto map = std::dynamic_pointer_cast<mrpt::maps::CPointsMapXYZI>(cloud->pointcloud);
  ASSERT_TRUE(map);
  std::size_t row = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (labels.state[i] != state) continue;
    ASSERT_LT(row, map->size());
    float x = 0, y = 0, z = 0;
    map->getPoint(row, x, y, z);
    EXPECT_EQ(x, scan.points.x[i]);
    EXPECT_EQ(y, scan.points.y[i]);
    EXPECT_EQ(z, scan.points.z[i]);
    EXPECT_EQ(map->getPointIntensity(row), scan.points.intensity[i]);
    ++row;
  }
  EXPECT_EQ(map->size(), row);
}

TEST(FilteredRawlogTest, HoldsPoseAndBothCloudsOfEveryScan) {
  using Compression = FilteredRawlogWriter::Compression;
  for (const Compression compression : {Compression::Plain, Compression::Gz}) {
    const TemporaryFolder folder;
    FilteredRawlogWriter writer(folder / "filtered.rawlog", compression);
    for (std::uint64_t i = 0; i < 5; ++i) writer.add(scanOnRobot(i), labelsOf(scanOnRobot(i)));
    EXPECT_FALSE(fs::exists(folder / "filtered.rawlog"));
    writer.finish();
    const auto objects = readAll(folder / "filtered.rawlog");
    ASSERT_EQ(objects.size(), 15u);
    for (std::uint64_t i = 0; i < 5; ++i) {
      const PosedScan scan = scanOnRobot(i);
      const auto pose = std::dynamic_pointer_cast<CObservationRobotPose>(objects[3 * i]);
      ASSERT_TRUE(pose);
      EXPECT_NEAR(fromMrptTime(pose->timestamp), scan.time, 1e-7);
      EXPECT_TRUE((fromMrpt(pose->pose.mean) * fromMrpt(pose->sensorPose) * scan.robotFromSensor)
                      .isApprox(scan.mapFromSensor, 1e-12));
      expectCloud(objects[3 * i + 1], scan, labelsOf(scan), PointState::Static, "LIDAR_STATIC");
      expectCloud(objects[3 * i + 2], scan, labelsOf(scan), PointState::Moving, "LIDAR_MOVING");
    }
  }
}

TEST(FilteredRawlogTest, WritesEmptyCloudsAndPointsWithoutIntensity) {
  const TemporaryFolder folder;
  PosedScan scan = makeScan(0, 4);
  scan.points.intensity.clear();
  ScanLabels labels;
  labels.state.assign(4, PointState::Static);
  FilteredRawlogWriter writer(folder / "filtered.rawlog");
  writer.add(scan, labels);
  writer.finish();
  const auto objects = readAll(folder / "filtered.rawlog");
  ASSERT_EQ(objects.size(), 3u);
  const auto sizeOfCloud = [&](std::size_t i) {
    return std::dynamic_pointer_cast<CObservationPointCloud>(objects[i])->pointcloud->size();
  };
  EXPECT_EQ(sizeOfCloud(1), 4u);
  EXPECT_EQ(sizeOfCloud(2), 0u);
}

TEST(FilteredRawlogTest, RefusesLabelsOfAnotherScan) {
  const TemporaryFolder folder;
  FilteredRawlogWriter writer(folder / "filtered.rawlog");
  EXPECT_THROW(writer.add(makeScan(1), labelsOf(makeScan(2))), std::logic_error);
  ScanLabels tooFew = labelsOf(makeScan(1));
  tooFew.state.pop_back();
  EXPECT_THROW(writer.add(makeScan(1), tooFew), std::logic_error);
}

}  // namespace
}  // namespace toss::test
