// SPDX-License-Identifier: BSD-3-Clause
// Poses from files and from the scans alone.
#include "CrossingLog.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

class Odometry : public CrossingLog {};

TEST_F(Odometry, MapsALogWithoutPosesAsWithThePosesThatItLeaves) {
  const fs::path found = map(rawlog(), "found", "--odometry --no-snapshots");
  ASSERT_TRUE(fs::exists(found / "poses.txt"));
  runWell("odometry " + quoted(rawlog()) + " --out " + quoted(in("poses.txt")));
  EXPECT_TRUE(readBytes(found / "poses.txt") == readBytes(in("poses.txt")));
  const fs::path given =
      map(rawlog(), "given", "--no-snapshots --poses " + quoted(in("poses.txt")));
  expectSameResult(found, given);
  const fs::path again =
      map(rawlog(), "again", "--no-snapshots --config " + quoted(found / "config.ini"));
  expectSameResult(found, again);
}

TEST_F(Odometry, WritesEveryFormatThatItReads) {
  const fs::path file = in("kitti.txt");
  runWell("odometry " + quoted(rawlog()) + " --format kitti --to 4 --out " + quoted(file));
  const ProgramRun info = runWell("info " + quoted(rawlog()) + " --poses " + quoted(file));
  EXPECT_THAT(info.out, HasSubstr("poses: 5,"));
  EXPECT_THAT(complaintOf("odometry " + quoted(rawlog()) + " --format kitti --from 3 --out " +
                          quoted(in("late.txt"))),
              HasSubstr("scan 0 has no pose"));
  EXPECT_FALSE(fs::exists(in("late.txt")));
}

TEST_F(Odometry, RefusesTwoSourcesOfPoses) {
  EXPECT_THAT(complaintOf("map " + quoted(rawlog()) + " --odometry --poses a.txt --out " +
                          quoted(in("both"))),
              HasSubstr("leave one of them away"));
}

}  // namespace
}  // namespace toss::test
