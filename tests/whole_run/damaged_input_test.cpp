// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingLog.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

/// Logs that begin well and are damaged farther on.
class DamagedInput : public CrossingLog {
 protected:
  /// Maps `input` into an empty folder and into one that holds a run: both stay as they are.
  static std::string complaint(const fs::path& input) {
    const std::string map = "map --no-snapshots " + quoted(input) + " --out ";
    const std::string line = complaintOf(map + quoted(in("none")));
    EXPECT_TRUE(filesIn(in("none")).empty()) << filesIn(in("none")).begin()->first;
    EXPECT_THAT(line, HasSubstr(input.filename().string()));
    const auto before = filesIn(run());
    complaintOf(map + quoted(run()));
    EXPECT_TRUE(filesIn(run()) == before);
    return line;
  }
};

TEST_F(DamagedInput, RawlogCutInTheMiddle) {
  const std::string bytes = readBytes(rawlog());
  writeBytes(in("cut.rawlog"), bytes.substr(0, bytes.size() / 2));
  complaint(in("cut.rawlog"));
}

TEST_F(DamagedInput, CompressedRawlogCutInTheMiddle) {
  runWell("simulate crossing " + quoted(in("kitti")) + " --format kitti");
  runWell("import kitti --gz " + quoted(in("kitti")) + " " + quoted(in("whole.rawlog")));
  const std::string bytes = readBytes(in("whole.rawlog"));
  writeBytes(in("cut_gz.rawlog"), bytes.substr(0, bytes.size() / 2));
  complaint(in("cut_gz.rawlog"));
}

TEST_F(DamagedInput, RawlogOverwrittenInTheMiddle) {
  std::string bytes = readBytes(rawlog());
  // The middle of the log, up to where another object must begin.
  bytes.replace(bytes.size() / 2, 600000, std::string(600000, 'x'));
  writeBytes(in("garbled.rawlog"), bytes);
  complaint(in("garbled.rawlog"));
}

TEST_F(DamagedInput, FolderWithAScanCutInTheMiddleOfAPoint) {
  runWell("simulate crossing " + quoted(in("torn")) + " --format kitti");
  const fs::path scan = in("torn") / "velodyne" / "000020.bin";
  fs::resize_file(scan, fs::file_size(scan) - 7);
  EXPECT_THAT(complaintOf("map " + quoted(in("torn")) + " --out " + quoted(in("none"))),
              HasSubstr("000020.bin"));
  EXPECT_TRUE(filesIn(in("none")).empty());
}

}  // namespace
}  // namespace toss::test
