// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationPointCloud.h>
#include <toss/rawlog/LabelFile.h>

#include <nlohmann/json.hpp>
#include <set>

#include "Program.h"

namespace toss::test {
namespace {

/// A rawlog with two LiDARs of different beams and places on one robot.
class MultiLidars : public ::testing::Test {
 protected:
  static constexpr std::size_t kScans = 30;

  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    runWell("simulate crossing " + quoted(log()) + " --second-sensor OS1-64 --frames 15");
    map("run", "");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static fs::path in(const std::string& name) { return *folder_ / name; }
  static fs::path log() { return in("two.rawlog"); }
  static fs::path map(const std::string& name, const std::string& options) {
    runWell("map " + quoted(log()) + " --no-snapshots --out " + quoted(in(name)) + " " + options);
    return in(name);
  }
  static nlohmann::json json(const fs::path& file) {
    return nlohmann::json::parse(readBytes(file));
  }
  static std::size_t movingIn(const std::string& labels) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < labels.size(); i += 4)
      count += static_cast<unsigned char>(labels[i]) == label::kMoving;
    return count;
  }

 private:
  static inline std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(MultiLidars, AreAllMappedAndTold) {
  const auto summary = json(in("run") / "summary.json");
  EXPECT_EQ(summary["scans"]["mapped"], kScans);
  ASSERT_EQ(summary["lidars"].size(), 2u);
  EXPECT_EQ(summary["lidars"][0]["model"], "VLP-16");
  EXPECT_EQ(summary["lidars"][1]["label"], "OS1-64-second");
  EXPECT_EQ(summary["lidars"][1]["model"], "OS1-64");
  EXPECT_EQ(summary["lidars"][1]["scans"], kScans / 2);
}

/// But for residue, of which all LiDARs together say whether anything else was in its place.
TEST_F(MultiLidars, HaveTheLabelsThatEachHasAlone) {
  const std::string apart = "--set decision.residue_place=0";
  map("both", apart);
  const auto both = filesIn(in("both") / "labels");
  ASSERT_EQ(both.size(), kScans);
  const char* names[] = {"VLP-16", "OS1-64-second"};
  for (std::size_t lidar = 0; lidar < 2; ++lidar) {
    const fs::path alone = map("alone", apart + " --set input.sensor_label=" + names[lidar]);
    std::size_t moving = 0;
    for (std::size_t i = 0; i < kScans / 2; ++i) {
      const std::string labels = readBytes(labelPath(alone / "labels", i));
      EXPECT_EQ(movingIn(labels),
                movingIn(readBytes(labelPath(in("both") / "labels", 2 * i + lidar))));
      moving += movingIn(labels);
    }
    EXPECT_GT(moving, 100u) << names[lidar];
  }
}

TEST_F(MultiLidars, ScoreAsWellAsOne) {
  runWell("eval " + quoted(log()) + " " + quoted(in("run")) + " --json " + quoted(in("scores")));
  const auto scores = json(in("scores"));
  EXPECT_EQ(scores["scans"], kScans);
  EXPECT_GT(scores["moving"]["iou"].get<double>(), 0.8) << scores.dump(1);
}

TEST_F(MultiLidars, GiveTheSameBytesWithOneThreadTilesAndTheirConfiguration) {
  expectSameFiles(in("run"), map("one_thread", "--threads 1"));
  expectSameFiles(in("run"), map("again", "--config " + quoted(in("run") / "config.ini")));
  const fs::path tiles = map("tiles", "--set map.tile_size=10 --set map.tiles_keep_radius=10");
  EXPECT_TRUE(readBytes(tiles / "static_map.ply") == readBytes(in("run") / "static_map.ply"));
}

TEST_F(MultiLidars, KeepTheirPlacesInTheFilteredLog) {
  std::set<double> heights;
  std::set<std::string> labels;
  std::size_t clouds = 0;
  for (const Object& object : objectsOf(in("run") / "filtered.rawlog"))
    if (const auto cloud = std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(object)) {
      heights.insert(cloud->sensorPose.z());
      labels.insert(cloud->sensorLabel);
      ++clouds;
    }
  EXPECT_EQ(clouds, 2 * kScans);
  EXPECT_EQ(heights.size(), 2u);
  EXPECT_EQ(labels,
            (std::set<std::string>{"LIDAR_STATIC", "LIDAR_MOVING", "LIDAR_STATIC_OS1-64-second",
                                   "LIDAR_MOVING_OS1-64-second"}));
}

TEST_F(MultiLidars, AreCheckedByTheFirst) {
  const ProgramRun check = runProgram("check " + quoted(log()));
  EXPECT_EQ(check.code, 0) << check.out << check.error;
  EXPECT_THAT(check.out, ::testing::HasSubstr(": 15 scans, sensor VLP-16"));
  EXPECT_THAT(check.out,
              ::testing::HasSubstr("several LiDARs will be mapped ('VLP-16', 'OS1-64-second')"));
}

TEST_F(MultiLidars, NeedPosesOfTheFirstOnly) {
  const fs::path found = map("odometry", "--odometry");
  const auto summary = json(found / "summary.json");
  // The last scan of the second LiDAR comes after the last pose of the first.
  EXPECT_EQ(summary["scans"]["mapped"], kScans - 1);
  EXPECT_EQ(summary["lidars"][1]["scans"], kScans / 2 - 1);
}

TEST_F(MultiLidars, MappingTheFilteredLogTakesWhatIsStatic) {
  runWell("map " + quoted(in("run") / "filtered.rawlog") + " --no-snapshots --out " +
          quoted(in("second")));
  const auto summary = json(in("second") / "summary.json");
  ASSERT_EQ(summary["lidars"].size(), 2u);
  EXPECT_EQ(summary["lidars"][0]["label"], "LIDAR_STATIC");
  EXPECT_EQ(summary["lidars"][1]["label"], "LIDAR_STATIC_OS1-64-second");
}

}  // namespace
}  // namespace toss::test
