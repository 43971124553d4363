// SPDX-License-Identifier: BSD-3-Clause
// Programs of MRPT (Debian package mrpt-apps) on the logs that this one writes.
#include "CrossingLog.h"

namespace toss::test {
namespace {

class MrptPrograms : public CrossingLog {
 protected:
  void SetUp() override {
    if (std::system("command -v rawlog-edit >/dev/null") != 0)
      GTEST_SKIP() << "rawlog-edit is not installed (package mrpt-apps)";
  }

  static std::string rawlogEdit(const std::string& arguments) {
    const std::string command = "rawlog-edit -w " + arguments + " >" + quoted(in("said")) + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << readBytes(in("said"));
    return readBytes(in("said"));
  }
  static std::size_t linesOf(const fs::path& file) {
    const std::string text = readBytes(file);
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(MrptPrograms, FindAllObservations) {
  const std::string info = rawlogEdit("--info -i " + quoted(rawlog()));
  EXPECT_THAT(info, ::testing::ContainsRegex("number of objects +: 60"));
  EXPECT_THAT(info, ::testing::HasSubstr("POSE, VLP-16"));
  const std::string filtered = rawlogEdit("--info -i " + quoted(run() / "filtered.rawlog"));
  EXPECT_THAT(filtered, ::testing::ContainsRegex("number of objects +: 90"));
  EXPECT_THAT(filtered, ::testing::HasSubstr("LIDAR_MOVING, LIDAR_STATIC, POSE"));
}

TEST_F(MrptPrograms, ListThePosesOfTheSensors) {
  for (const fs::path& log : {rawlog(), run() / "filtered.rawlog"}) {
    rawlogEdit("--list-poses -i " + quoted(log) + " --text-file-output " + quoted(in("poses.txt")));
    EXPECT_GE(linesOf(in("poses.txt")), kScans) << log;
  }
}

TEST_F(MrptPrograms, CutLogsThatCanStillBeMapped) {
  rawlogEdit("--cut --from-index 20 --to-index 39 -i " + quoted(rawlog()) + " -o " +
             quoted(in("cut.rawlog")));
  // The times of the returns, which stay with the whole log, would have them de-skewed there only.
  InputOptions asRecorded;
  asRecorded.deskew = Deskew::Off;
  const ReadInput cut = readInput(in("cut.rawlog"), asRecorded),
                  whole = readInput(rawlog(), asRecorded);
  ASSERT_EQ(cut.scans.size(), 10u);
  for (std::size_t i = 0; i < cut.scans.size(); ++i)
    expectSameScan(cut.scans[i], whole.scans[i + 10]);
  map(in("cut.rawlog"), "cut_run");
  EXPECT_TRUE(fs::exists(in("cut_run") / "static_map.ply"));
}

TEST_F(MrptPrograms, CutWhatTossMapHasFiltered) {
  rawlogEdit("--cut --from-index 30 --to-index 59 -i " + quoted(run() / "filtered.rawlog") +
             " -o " + quoted(in("cut_filtered.rawlog")));
  InputOptions options;
  options.sensorLabel = "LIDAR_STATIC";
  EXPECT_EQ(readInput(in("cut_filtered.rawlog"), options).scans.size(), 10u);
}

}  // namespace
}  // namespace toss::test
