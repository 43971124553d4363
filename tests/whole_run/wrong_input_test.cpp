// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingLog.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// Inputs that are no logs at all.
class WrongInput : public CrossingLog {
 protected:
  /// What every command that reads a log says of `input`; nothing is left behind.
  static std::string complaint(const fs::path& input) {
    EXPECT_THAT(complaintOf("info " + quoted(input)), HasSubstr(input.filename().string()));
    const std::string line = complaintOf("map " + quoted(input) + " --out " + quoted(in("none")));
    EXPECT_TRUE(filesIn(in("none")).empty());
    EXPECT_THAT(line, HasSubstr(input.filename().string()));
    return line;
  }
};

TEST_F(WrongInput, Missing) {
  EXPECT_THAT(complaint(in("absent.rawlog")), HasSubstr("does not exist"));
}

TEST_F(WrongInput, Text) {
  writeBytes(in("notes.rawlog"), "scan the hall\nthen the yard\n");
  EXPECT_THAT(complaint(in("notes.rawlog")), HasSubstr("not a rawlog"));
}

TEST_F(WrongInput, Empty) {
  writeBytes(in("empty.rawlog"), "");
  complaint(in("empty.rawlog"));
}

TEST_F(WrongInput, EmptyFolder) {
  fs::create_directories(in("hollow"));
  complaint(in("hollow"));
}

TEST_F(WrongInput, LogWithoutScans) {
  std::vector<Object> objects;
  for (int i = 0; i < 5; ++i) objects.push_back(poseObservation(1.6e9 + i, poseOf(i, 0, 0, 0)));
  writeObjects(in("poses.rawlog"), objects);
  const ProgramRun result =
      runProgram("-q map " + quoted(in("poses.rawlog")) + " --out " + quoted(in("none")));
  EXPECT_EQ(result.code, 1);
  EXPECT_THAT(result.error, HasSubstr("poses.rawlog"));
  EXPECT_TRUE(filesIn(in("none")).empty());
}

TEST_F(WrongInput, LogWithoutPoses) {
  std::vector<Object> objects;
  for (const PosedScan& scan : readInput(rawlog()).scans)
    objects.push_back(cloudObservation(scan.time, scan));
  writeObjects(in("lost.rawlog"), objects);
  const std::string map = "map " + quoted(in("lost.rawlog")) + " --out " + quoted(in("none"));
  EXPECT_THAT(complaintOf(map), HasSubstr("pose"));
  EXPECT_THAT(complaintOf(map + " --set sensor.model=VLP-16"), HasSubstr("pose"));
  EXPECT_TRUE(filesIn(in("none")).empty());
}

TEST_F(WrongInput, TimeThatGoesBackwardsIsSkippedAndReported) {
  std::vector<Object> objects;
  const auto scans = readInput(rawlog()).scans;
  for (const std::size_t i : {0, 1, 2, 5, 4, 3, 6, 7, 7, 8}) {
    objects.push_back(poseObservation(scans[i].time, scans[i].mapFromSensor));
    objects.push_back(cloudObservation(scans[i].time, scans[i]));
  }
  writeObjects(in("shuffled.rawlog"), objects);
  const ProgramRun result = runProgram("map " + quoted(in("shuffled.rawlog")) +
                                       " --no-snapshots --out " + quoted(in("shuffled")));
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_THAT(result.out, HasSubstr("note: "));
  const std::string summary = readBytes(in("shuffled") / "summary.json");
  EXPECT_EQ(summary.find("\"skipped_for_time\": 0"), std::string::npos) << summary;
}

}  // namespace
}  // namespace toss::test
