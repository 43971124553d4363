// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/geometry/Error.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/ScanSource.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/simulation/SimulateTo.h>

#include <filesystem>

namespace toss {
namespace {

namespace fs = std::filesystem;

class SimulateTo : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("toss_simulate_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    options_.scene = "crossing";
    options_.frames = 3;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Reads the log back and compares it with the simulator's own scans.
  void expectLog(const fs::path& log) {
    const auto source = openScans(log, InputOptions());
    Simulator simulator(options_);
    PosedScan read;
    for (SimulatedScan made; simulator.next(made);) {
      ASSERT_TRUE(source->next(read));
      EXPECT_EQ(read.points.x, made.scan.points.x);
      EXPECT_EQ(read.points.z, made.scan.points.z);
      EXPECT_TRUE(read.mapFromSensor.isApprox(made.scan.mapFromSensor, 1e-9));
      const auto labels = labelPath(labelsFolderOf(log), made.scan.index);
      EXPECT_EQ(readLabels(labels, made.labels.size()), made.labels);
    }
    EXPECT_FALSE(source->next(read));
  }

  void expectTracks(const fs::path& file) {
    const std::vector<TrackRow> rows = readTracksCsv(file);
    Simulator simulator(options_);
    std::size_t row = 0;
    for (SimulatedScan made; simulator.next(made);) {
      for (const GroundTruthBox& box : made.boxes) {
        ASSERT_LT(row, rows.size());
        EXPECT_EQ(rows[row].scan, made.scan.index);
        EXPECT_EQ(rows[row].sample.track, box.track);
        EXPECT_EQ(rows[row].sample.moving, box.moving);
        EXPECT_NEAR((rows[row].sample.box.center - box.box.center).norm(), 0.0, 2e-4);
        ++row;
      }
    }
    EXPECT_EQ(row, rows.size());
  }

  fs::path folder_;
  SimulationOptions options_;
};

TEST_F(SimulateTo, ARawlogReadsBackWithItsLabelsAndTracks) {
  int calls = 0;
  const SimulatedLog log =
      simulateTo(folder_ / "a.rawlog", LogFormat::Rawlog, options_, [&](int done, int total) {
        EXPECT_EQ(done, ++calls);
        EXPECT_EQ(total, 3);
      });
  EXPECT_EQ(log.scans, 3u);
  EXPECT_EQ(log.movers, 2u);
  EXPECT_GT(log.points, 10u * log.movingPoints);
  EXPECT_EQ(calls, 3);
  expectLog(folder_ / "a.rawlog");
  expectTracks(folder_ / "a_tracks.csv");
}

TEST_F(SimulateTo, AFolderReadsBackWithItsLabelsAndTracks) {
  simulateTo(folder_ / "k", LogFormat::Kitti, options_);
  expectLog(folder_ / "k");
  expectTracks(folder_ / "k/tracks.csv");
}

TEST_F(SimulateTo, NothingIsLeftBehindWhereTheSceneIsUnknown) {
  options_.scene = "nowhere";
  EXPECT_THROW(simulateTo(folder_ / "a.rawlog", LogFormat::Rawlog, options_), UserError);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(SimulateTo, FormatsAreKnownByName) {
  EXPECT_EQ(logFormatByName("rawlog"), LogFormat::Rawlog);
  EXPECT_EQ(logFormatByName("kitti"), LogFormat::Kitti);
  EXPECT_THROW(logFormatByName("kiti"), UserError);
}

}  // namespace
}  // namespace toss
