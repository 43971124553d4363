// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/MetricMapFile.h>
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/render/MapContent.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

ScanLabels labelsWith(std::uint64_t scan, bool firstMoves) {
  ScanLabels labels;
  labels.scan = scan;
  for (const TrackId id : {TrackId{3}, TrackId{8}}) {
    TrackSample sample;
    sample.track = id;
    sample.moving = id == 8 || firstMoves;
    sample.box.center.x() = static_cast<double>(10 * id + scan);
    labels.tracks.push_back(sample);
  }
  return labels;
}

TEST(MapContentTest, CollectsThePathsOfMovingTraces) {
  TrackPathCollector collector;
  collector.add(labelsWith(0, false));
  collector.add(labelsWith(1, true));
  const auto paths = collector.paths();
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(paths[0].track, 3u);
  ASSERT_EQ(paths[0].boxes.size(), 1u);
  EXPECT_EQ(paths[0].boxes[0].center.x(), 31.0);
  EXPECT_EQ(paths[1].boxes.size(), 2u);
}

TEST(MapContentTest, KeepsTheLongestPathsOfManyTraces) {
  constexpr std::size_t kLimit = 10;
  TrackPathCollector collector(kLimit);
  for (std::uint64_t scan = 0; scan < 200; ++scan) {
    ScanLabels labels;
    labels.scan = scan;
    TrackSample sample;
    sample.moving = true;
    sample.track = 1 + scan;
    labels.tracks.push_back(sample);
    // Every twentieth trace is seen for two scans.
    if (scan % 20 == 1) labels.tracks.front().track = scan;
    collector.add(labels);
  }
  const auto paths = collector.paths();
  EXPECT_EQ(collector.count(), 190u);
  EXPECT_LE(paths.size(), 2 * kLimit);
  EXPECT_EQ(std::count_if(paths.begin(), paths.end(),
                          [](const TrackPath& path) { return path.boxes.size() == 2; }),
            10);
}

TEST(MapContentTest, ReadsRunsAndPointFilesTogether) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "run");
  writePly(folder / "run" / "static_map.ply", {{1, 2, 3, 0.5f}, {4, 5, 6, 0.5f}});
  writePly(folder / "run" / "moving_points.ply", {{7, 8, 9, 0.5f}});
  TracksCsvWriter tracks(folder / "run" / "tracks.csv");
  tracks.add(labelsWith(0, false));
  tracks.finish();
  writeMetricMap(folder / "other.metricmap", {{10, 11, 12, 1.0f}});
  const MapContent content = readMapContent({folder / "run", folder / "other.metricmap"}, 1000);
  EXPECT_EQ(content.name, "run + other.metricmap");
  ASSERT_EQ(content.staticPoints.size(), 3u);
  EXPECT_EQ(content.staticPoints[2].y, 11.0f);
  ASSERT_EQ(content.movingPoints.size(), 1u);
  ASSERT_EQ(content.tracks.size(), 1u);
  EXPECT_EQ(content.tracks[0].track, 8u);
}

TEST(MapContentTest, BringsFilesToTheOffsetOfTheFirst) {
  const TemporaryFolder folder;
  const Eigen::Vector3d utm(457000.0, 5428000.0, 0.0), near(456000.0, 5428000.0, 0.0);
  fs::create_directory(folder / "run");
  writePly(folder / "run" / "static_map.ply", {{1, 2, 3, 0.5f}}, utm);
  writePly(folder / "run" / "moving_points.ply", {{7, 8, 9, 0.5f}}, utm);
  writePly(folder / "other.ply", {{1234.5f, 11, 12, 1.0f}}, near);
  TracksCsvWriter tracks(folder / "run" / "tracks.csv");
  ScanLabels labels = labelsWith(0, true);
  for (TrackSample& sample : labels.tracks) sample.box.center += utm;
  tracks.add(labels);
  tracks.finish();
  const MapContent content = readMapContent({folder / "run", folder / "other.ply"}, 1000);
  EXPECT_EQ(content.offset, utm);
  ASSERT_EQ(content.staticPoints.size(), 2u);
  EXPECT_EQ(content.staticPoints[0].x, 1.0f);
  EXPECT_EQ(content.staticPoints[1].x, 234.5f);
  EXPECT_EQ(content.movingPoints.at(0).z, 9.0f);
  TrackPathCollector collector;
  collector.add(labels, utm);
  ASSERT_EQ(content.tracks.size(), collector.paths().size());
  EXPECT_EQ(content.tracks[0].boxes[0].center, collector.paths()[0].boxes[0].center);
}

TEST(MapContentTest, NamesFoldersThatAreNoRun) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "empty");
  EXPECT_THAT(userErrorOf([&] { readMapContent({folder / "empty"}, 10); }),
              ::testing::HasSubstr("no static_map.ply"));
  EXPECT_NE(userErrorOf([&] { readMapContent({folder / "none.ply"}, 10); }), "");
}

}  // namespace
}  // namespace toss::test
