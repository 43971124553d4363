// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/PlyFile.h>

#include <nlohmann/json.hpp>

#include "CrossingLog.h"

namespace toss::test {
namespace {

/// Options that choose what is read and what is written.
class Selection : public CrossingLog {
 protected:
  static nlohmann::json summary(const fs::path& folder) {
    return nlohmann::json::parse(readBytes(folder / "summary.json"));
  }
  static std::vector<std::string> labelNames(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& [name, bytes] : filesIn(folder)) names.push_back(name);
    return names;
  }
};

TEST_F(Selection, FromAndToKeepTheNumbersOfTheScans) {
  const fs::path part = map(rawlog(), "part", "--no-snapshots --from 5 --to 9");
  EXPECT_THAT(labelNames(part / "labels"),
              ::testing::ElementsAre("000005.label", "000006.label", "000007.label", "000008.label",
                                     "000009.label"));
  EXPECT_EQ(summary(part)["scans"]["mapped"], 5);
  EXPECT_EQ(readBytes(part / "tracks.csv").find("\n4,"), std::string::npos);
}

TEST_F(Selection, ToBehindTheEndTakesAllThatIsThere) {
  const fs::path tail = map(rawlog(), "tail", "--no-snapshots --from 28 --to 500");
  EXPECT_THAT(labelNames(tail / "labels"), ::testing::ElementsAre("000028.label", "000029.label"));
}

TEST_F(Selection, KeepLeansTheVerdictAndIsWrittenIntoTheConfiguration) {
  const auto moving = [](const fs::path& folder) {
    return summary(folder)["points"]["moving"].get<long>();
  };
  const fs::path strict = map(rawlog(), "strict", "--no-snapshots --keep remove");
  const fs::path careful = map(rawlog(), "careful", "--no-snapshots --keep static");
  EXPECT_GT(moving(strict), moving(careful));
  const fs::path again =
      map(rawlog(), "again", "--no-snapshots --config " + quoted(strict / "config.ini"));
  EXPECT_EQ(filesIn(strict / "labels"), filesIn(again / "labels"));
}

TEST_F(Selection, NothingMoreIsWrittenThanAskedFor) {
  const fs::path lean = map(rawlog(), "lean", "--no-snapshots --to 4");
  EXPECT_FALSE(fs::exists(lean / "snapshots"));
  EXPECT_FALSE(fs::exists(lean / "live_labels"));
  EXPECT_FALSE(fs::exists(lean / "instances"));
}

TEST_F(Selection, LiveLabelsAreAlignedAndIndependentOfWhatComesLater) {
  const fs::path all = map(rawlog(), "live", "--no-snapshots --live-labels");
  const fs::path begin = map(rawlog(), "begin", "--no-snapshots --live-labels --to 14");
  const auto live = filesIn(all / "live_labels"), early = filesIn(begin / "live_labels");
  ASSERT_EQ(live.size(), kScans);
  ASSERT_EQ(early.size(), 15u);
  const auto labels = filesIn(all / "labels");
  bool anyMoving = false, anyDifference = false;
  for (const auto& [name, bytes] : live) {
    EXPECT_EQ(bytes.size(), labels.at(name).size());
    anyDifference = anyDifference || bytes != labels.at(name);
    if (early.count(name)) {
      EXPECT_TRUE(early.at(name) == bytes) << name;
    }
    for (std::size_t i = 0; i < bytes.size(); i += 4)
      anyMoving = anyMoving || static_cast<unsigned char>(bytes[i]) == label::kMoving;
  }
  EXPECT_TRUE(anyMoving);
  EXPECT_TRUE(anyDifference);
}

TEST_F(Selection, VoxelSizeZeroKeepsEveryReturnThatIsStatic) {
  const std::string options =
      "--no-snapshots --set map.voxel_size=0 --set map.keep_below_ground=true";
  const fs::path every = map(rawlog(), "every", options);
  std::size_t kept = 0;
  for (const auto& [name, bytes] : filesIn(every / "labels"))
    for (std::size_t i = 0; i < bytes.size(); i += 4)
      kept += static_cast<unsigned char>(bytes[i]) == label::kStatic;
  EXPECT_GT(kept, 500000u);
  EXPECT_EQ(readPointCloudFile(every / "static_map.ply").size(), kept);
}

TEST_F(Selection, QuietRunsSayNothingAndOthersSumUp) {
  const std::string arguments =
      "map " + quoted(rawlog()) + " --to 3 --no-snapshots --out " + quoted(in("said"));
  const ProgramRun quiet = runProgram("-q " + arguments), loud = runProgram(arguments);
  EXPECT_EQ(quiet.code, 0);
  EXPECT_EQ(quiet.out + quiet.error, "");
  EXPECT_THAT(loud.out, ::testing::HasSubstr("4 scans mapped"));
  EXPECT_EQ(runProgram(arguments + " --quiet").out, "");
}

TEST_F(Selection, ScansWithoutAPoseAreSkippedAndReported) {
  std::vector<Object> objects;
  for (const PosedScan& scan : readInput(rawlog()).scans) {
    if (scan.index < 12 || scan.index > 16)
      objects.push_back(poseObservation(scan.time, scan.mapFromSensor));
    objects.push_back(cloudObservation(scan.time, scan));
  }
  writeObjects(in("gap.rawlog"), objects);
  const ProgramRun result =
      runProgram("map " + quoted(in("gap.rawlog")) + " --no-snapshots --out " + quoted(in("gap")));
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.out, ::testing::HasSubstr("skipped (no pose)"));
  const auto json = summary(in("gap"));
  const std::uint64_t skipped = json["scans"]["skipped_for_pose"];
  EXPECT_GE(skipped, 3u);
  EXPECT_LE(skipped, 5u);
  EXPECT_EQ(json["scans"]["mapped"], kScans - skipped);
  EXPECT_FALSE(json["warnings"].empty());
  EXPECT_FALSE(fs::exists(labelPath(in("gap") / "labels", 14)));
  EXPECT_TRUE(fs::exists(labelPath(in("gap") / "labels", 29)));
}

}  // namespace
}  // namespace toss::test
