// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

TEST(Imports, ARealOusterCaptureIsMappedWithoutFurtherOptions) {
  const fs::path stem = dataFolder() / "ouster/OS-1-128_v2.3.0_1024x10";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const TemporaryFolder folder;
  const std::string rawlog = quoted(folder / "a.rawlog");
  runWell("import ouster " + quoted(stem.string() + "_lb_n3.pcap") + " " +
          quoted(stem.string() + ".json") + " " + rawlog + " --poses " +
          quoted(stem.string() + "_lb_n3_poses_kitti.txt"));
  EXPECT_THAT(runProgram("info " + rawlog).out, HasSubstr("sensor OS1-128"));
  runWell("map " + rawlog + " --no-snapshots --out " + quoted(folder / "run"));
  // The preset of the model that the metadata name.
  EXPECT_THAT(readBytes(folder / "run/config.ini"), HasSubstr("\nextent = 40\n"));
  const auto labels = filesIn(folder / "run/labels");
  EXPECT_EQ(labels.size(), 3u);
  EXPECT_GT(fs::file_size(folder / "run/static_map.ply"), 1'000'000u);
}

TEST(Imports, ACaptureWithoutPosesIsToldWhereToGetThem) {
  const fs::path stem = dataFolder() / "ouster/OS-1-128_v2.3.0_1024x10";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const TemporaryFolder folder;
  runWell("import ouster " + quoted(stem.string() + "_lb_n3.pcap") + " " +
          quoted(stem.string() + ".json") + " " + quoted(folder / "a.rawlog"));
  EXPECT_THAT(
      complaintOf("map " + quoted(folder / "a.rawlog") + " --out " + quoted(folder / "run")),
      ::testing::AllOf(HasSubstr("holds no poses"), HasSubstr("--poses FILE"),
                       HasSubstr("--odometry")));
}

TEST(Imports, WrongFilesAreNamed) {
  const TemporaryFolder folder;
  writeBytes(folder / "a.pcap", "no capture");
  writeBytes(folder / "meta.json", "{}");
  const std::string out = " " + quoted(folder / "a.rawlog");
  EXPECT_THAT(complaintOf("import ouster " + quoted(folder / "a.pcap") + " " +
                          quoted(folder / "meta.json") + out),
              HasSubstr("meta.json"));
  EXPECT_THAT(complaintOf("import pcd " + quoted(folder / "none") + out), HasSubstr("none"));
  EXPECT_THAT(complaintOf("import pcd " + quoted(folder / "") + out + " --frame robot"),
              HasSubstr("--frame"));
  EXPECT_THAT(complaintOf("import pcd " + quoted(folder / "") + out + " --labels class"),
              HasSubstr("--labels"));
  EXPECT_FALSE(fs::exists(folder / "a.rawlog"));
}

}  // namespace
}  // namespace toss::test
