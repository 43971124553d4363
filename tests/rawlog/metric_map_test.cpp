// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <tbb/global_control.h>
#include <toss/rawlog/MetricMapFile.h>
#include <toss/rawlog/PlyFile.h>

#include <cmath>

#include "InputFixtures.h"

namespace toss::test {
namespace {

std::vector<MapPoint> somePoints() {
  std::vector<MapPoint> points;
  for (int i = 0; i < 3000; ++i) {
    const auto v = static_cast<float>(i);
    points.push_back({0.1f * v, -0.2f * v, 1e-3f * v, v / 3000.0f});
  }
  return points;
}

TEST(MetricMapTest, IsOnePointMapForMrpt) {
  const TemporaryFolder folder;
  const auto points = somePoints();
  writeMetricMap(folder / "static_map.metricmap", points);
  mrpt::io::CFileGZInputStream stream((folder / "static_map.metricmap").string());
  const auto object = mrpt::serialization::archiveFrom(stream).ReadObject();
  const auto map = std::dynamic_pointer_cast<mrpt::maps::CPointsMapXYZI>(object);
  ASSERT_TRUE(map);
  ASSERT_EQ(map->size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    float x = 0, y = 0, z = 0;
    map->getPoint(i, x, y, z);
    EXPECT_EQ(x, points[i].x);
    EXPECT_EQ(y, points[i].y);
    EXPECT_EQ(z, points[i].z);
    EXPECT_EQ(map->getPointIntensity(i), points[i].intensity);
  }
}

std::string inflated(const std::filesystem::path& file) {
  mrpt::io::CFileGZInputStream stream(file.string());
  std::string bytes;
  char chunk[4096];
  while (const std::size_t got = stream.Read(chunk, sizeof chunk)) bytes.append(chunk, got);
  return bytes;
}

TEST(MetricMapTest, CopyOfAPlyIsTheObjectThatMrptWrites) {
  const TemporaryFolder folder;
  std::vector<MapPoint> points = somePoints();
  for (int doublings = 0; doublings < 4; ++doublings) {
    const std::vector<MapPoint> half = points;
    points.insert(points.end(), half.begin(), half.end());
  }
  for (const auto& all : {points, std::vector<MapPoint>(), std::vector<MapPoint>{{1, 2, 3, 4}}}) {
    writePly(folder / "map.ply", all);
    AtomicFile copy(folder / "copy.metricmap");
    copyToMetricMap(folder / "map.ply", copy);
    copy.commit();
    writeMetricMap(folder / "direct.metricmap", all);
    EXPECT_TRUE(inflated(folder / "copy.metricmap") == inflated(folder / "direct.metricmap"));
  }
}

TEST(MetricMapTest, IsReadBackAndTheSameBytesEachTime) {
  const TemporaryFolder folder;
  const auto points = somePoints();
  writeMetricMap(folder / "a.metricmap", points);
  writeMetricMap(folder / "b.metricmap", points);
  EXPECT_EQ(readBytes(folder / "a.metricmap"), readBytes(folder / "b.metricmap"));
  const auto read = readPointCloudFile(folder / "a.metricmap");
  ASSERT_EQ(read.size(), points.size());
  EXPECT_EQ(std::memcmp(read.data(), points.data(), points.size() * sizeof(MapPoint)), 0);
  writeMetricMap(folder / "empty.metricmap", {});
  EXPECT_TRUE(readMetricMap(folder / "empty.metricmap").empty());
}

/// Large enough for several rounds of blocks that are compressed at a time.
TEST(MetricMapTest, BytesDoNotDependOnThreadsAndAreOneFileForMrpt) {
  const TemporaryFolder folder;
  std::vector<MapPoint> points(1'200'000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto v = static_cast<float>(i);
    points[i] = {std::sin(v), std::cos(v), 1e-3f * v, 0.5f};
  }
  for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    writeMetricMap(folder / (std::to_string(threads) + ".metricmap"), points);
  }
  EXPECT_TRUE(readBytes(folder / "1.metricmap") == readBytes(folder / "3.metricmap"));
  const auto read = readMetricMap(folder / "3.metricmap");
  ASSERT_EQ(read.size(), points.size());
  EXPECT_EQ(std::memcmp(read.data(), points.data(), points.size() * sizeof(MapPoint)), 0);
}

TEST(MetricMapTest, TakesOtherPointMaps) {
  const TemporaryFolder folder;
  auto map = mrpt::maps::CSimplePointsMap::Create();
  map->insertPoint(1.0f, 2.0f, 3.0f);
  writeObjects(folder / "simple.metricmap", {map}, true);
  const auto points = readMetricMap(folder / "simple.metricmap");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].y, 2.0f);
  EXPECT_EQ(points[0].intensity, 0.0f);
}

TEST(MetricMapTest, RefusesWhatIsNoWholePointMap) {
  const TemporaryFolder folder;
  writeMetricMap(folder / "map.metricmap", somePoints());
  const std::string whole = readBytes(folder / "map.metricmap");
  for (const std::size_t length : {std::size_t{20}, whole.size() / 2}) {
    writeBytes(folder / "cut.metricmap", whole.substr(0, length));
    EXPECT_THAT(userErrorOf([&] { readMetricMap(folder / "cut.metricmap"); }),
                ::testing::HasSubstr("cut.metricmap: object 0"))
        << length;
  }
  writeObjects(folder / "pose.metricmap", {poseObservation(0.0, Eigen::Isometry3d::Identity())});
  EXPECT_THAT(userErrorOf([&] { readMetricMap(folder / "pose.metricmap"); }),
              ::testing::HasSubstr("no point map"));
  EXPECT_NE(userErrorOf([&] { readMetricMap(folder / "none.metricmap"); }), "");
}

}  // namespace
}  // namespace toss::test
