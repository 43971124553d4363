// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingLog.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// Where the outputs go.
class OutputFolder : public CrossingLog {
 protected:
  static std::string mapTo(const fs::path& output, const fs::path& input = rawlog()) {
    return "map --no-snapshots --to 5 " + quoted(input) + " --out " + quoted(output);
  }
};

TEST_F(OutputFolder, AFileInItsPlaceIsKept) {
  writeBytes(in("taken"), "something dear");
  EXPECT_THAT(complaintOf(mapTo(in("taken"))), HasSubstr("taken"));
  EXPECT_EQ(readBytes(in("taken")), "something dear");
}

TEST_F(OutputFolder, IsMadeWithTheFoldersAboveIt) {
  runWell(mapTo(in("new") / "deep" / "run"));
  EXPECT_TRUE(fs::exists(in("new") / "deep" / "run" / "summary.json"));
}

TEST_F(OutputFolder, IsNotThereAfterALogThatEndsInTheMiddleOfAScan) {
  const std::string bytes = readBytes(rawlog());
  writeBytes(in("cut.rawlog"), bytes.substr(0, bytes.size() / 2));
  complaintOf("map --no-snapshots " + quoted(in("cut.rawlog")) + " --out " +
              quoted(in("none") / "deep" / "run"));
  EXPECT_FALSE(fs::exists(in("none")));
  fs::create_directories(in("mine already"));
  complaintOf("map --no-snapshots " + quoted(in("cut.rawlog")) + " --out " +
              quoted(in("mine already")));
  EXPECT_TRUE(fs::is_empty(in("mine already")));
}

TEST_F(OutputFolder, LabelsOfADatasetAreNeverReplaced) {
  runWell("simulate crossing " + quoted(in("kitti")) + " --format kitti --frames 6");
  const auto before = filesIn(in("kitti"));
  complaintOf(mapTo(in("kitti"), in("kitti")));
  complaintOf(mapTo(in("kitti")));
  EXPECT_TRUE(filesIn(in("kitti")) == before);
}

TEST_F(OutputFolder, TheInputIsNeverReplaced) {
  fs::create_directories(in("mine"));
  fs::copy_file(rawlog(), in("mine") / "filtered.rawlog");
  complaintOf(mapTo(in("mine"), in("mine") / "filtered.rawlog"));
  EXPECT_TRUE(readBytes(in("mine") / "filtered.rawlog") == readBytes(rawlog()));
}

TEST_F(OutputFolder, ForgetsWhatAnEarlierRunLeft) {
  const fs::path folder = map(rawlog(), "reused", "--live-labels --instances --to 8");
  EXPECT_TRUE(fs::exists(folder / "live_labels"));
  runWell(mapTo(folder));
  EXPECT_EQ(filesIn(folder / "labels").size(), 6u);
  for (const char* name : {"live_labels", "instances", "snapshots"})
    EXPECT_FALSE(fs::exists(folder / name)) << name;
}

TEST_F(OutputFolder, AFullDiskIsToldAndLeavesNothing) {
  // Files larger than the limit can not be written, as on a disk that is full.
  const std::string limit = "trap '' XFSZ; ulimit -f 256;";
  EXPECT_THAT(complaintOf(mapTo(in("full")), limit), HasSubstr("can not be written"));
  EXPECT_FALSE(fs::exists(in("full") / "summary.json"));
  for (const auto& [name, bytes] : filesIn(in("full")))
    EXPECT_EQ(name.find("partial"), std::string::npos) << name;
  complaintOf("simulate crossing " + quoted(in("full.rawlog")), limit);
  EXPECT_FALSE(fs::exists(in("full.rawlog")));
}

TEST_F(OutputFolder, AnInterruptedCommandLeavesNothing) {
  // Twice, as timeout itself does: the second must not end the program in the middle of clearing.
  const std::string twice =
      "sh -c '\"$@\" & sleep 2; kill -TERM $!; sleep 0.002; kill -TERM $!; wait $!' sh";
  for (const std::string& stopper : {std::string("timeout --preserve-status -s INT 2"), twice}) {
    fs::create_directories(in("stopped"));
    const ProgramRun result = runProgram(
        "-q simulate crossing " + quoted(in("stopped") / "long.rawlog") + " --frames 100000",
        stopper);
    EXPECT_EQ(result.code, 130) << result.error;
    EXPECT_THAT(result.error, HasSubstr("interrupted"));
    EXPECT_TRUE(fs::is_empty(in("stopped")));
  }
}

}  // namespace
}  // namespace toss::test
