// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

TEST(CommandLine, EveryCommandHasHelpWithAnExample) {
  for (const std::string command :
       {"map", "import", "import kitti", "import ouster", "import velodyne", "import pcd",
        "simulate", "eval", "snapshot", "info", "check", "odometry", "config", "benchmark",
        "benchmark semantickitti"}) {
    const ProgramRun run = runProgram(command + " --help");
    EXPECT_EQ(run.code, 0) << command;
    EXPECT_THAT(run.out, HasSubstr("Example: toss " + command)) << command;
    EXPECT_EQ(run.error, "") << command;
  }
}

TEST(CommandLine, HelpListsTheCommands) {
  const ProgramRun run = runProgram("--help");
  EXPECT_EQ(run.code, 0);
  for (const char* command : {"map", "import", "simulate", "eval", "snapshot", "info", "config"})
    EXPECT_THAT(run.out, HasSubstr(command));
}

TEST(CommandLine, TellsItsVersion) {
  const ProgramRun run = runProgram("--version");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.out, "toss " TOSS_VERSION "\n");
}

TEST(CommandLine, MisspelledCommandsNameTheNearest) {
  EXPECT_THAT(complaintOf("mpa drive.rawlog --out result"), HasSubstr("did you mean 'map'?"));
  EXPECT_THAT(complaintOf("import kiti a b.rawlog"), HasSubstr("did you mean 'kitti'?"));
  EXPECT_THAT(complaintOf("--out"), HasSubstr("--help"));
  EXPECT_THAT(complaintOf(""), HasSubstr("--help"));
}

TEST(CommandLine, MissingAndUnknownArgumentsAreNamed) {
  EXPECT_THAT(complaintOf("map --out result"), HasSubstr("INPUT"));
  EXPECT_THAT(complaintOf("map drive.rawlog"), HasSubstr("--out"));
  EXPECT_THAT(complaintOf("map drive.rawlog --out result --form 3"), HasSubstr("--form"));
  EXPECT_THAT(complaintOf("map drive.rawlog --out result --from -3"), HasSubstr("--from"));
  EXPECT_THAT(complaintOf("map drive.rawlog --out result --to last"), HasSubstr("--to"));
  EXPECT_THAT(complaintOf("map drive.rawlog --out result --threads -1"), HasSubstr("--threads"));
  EXPECT_THAT(complaintOf("simulate crossing a.rawlog --seed -1"), HasSubstr("--seed"));
}

TEST(CommandLine, ListsTheScenes) {
  const ProgramRun run = runProgram("simulate --list");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("crossing"));
}

TEST(CommandLine, UnknownScenesSensorsAndViewsAreNamed) {
  const TemporaryFolder folder;
  const std::string out = quoted(folder / "out.rawlog");
  EXPECT_THAT(complaintOf("simulate crosing " + out), HasSubstr("did you mean 'crossing'?"));
  EXPECT_THAT(complaintOf("simulate crossing " + out + " --sensor VLP-61"), HasSubstr("VLP-16"));
  EXPECT_THAT(complaintOf("simulate crossing " + out + " --frames -4"), HasSubstr("frames"));
  EXPECT_THAT(complaintOf("simulate crossing " + out + " --format pcap"), HasSubstr("--format"));
  EXPECT_THAT(complaintOf("snapshot a.ply --out a.png --view below"), HasSubstr("--view"));
  EXPECT_THAT(complaintOf("snapshot a.ply --out a.png --size 640"), HasSubstr("WIDTHxHEIGHT"));
  EXPECT_THAT(complaintOf("config --sensor HDL-46E"), HasSubstr("HDL-64E"));
}

TEST(CommandLine, ConfigurationThatIsPrintedCanBeReadBack) {
  const TemporaryFolder folder;
  const ProgramRun first = runProgram("config --sensor VLP-16 --set map.voxel_size=0.25");
  EXPECT_THAT(first.out, HasSubstr("voxel_size"));
  writeBytes(folder / "my.ini", first.out);
  const ProgramRun second = runProgram("config --config " + quoted(folder / "my.ini"));
  EXPECT_EQ(second.code, 0);
  EXPECT_EQ(second.out, first.out);
}

}  // namespace
}  // namespace toss::test
