// SPDX-License-Identifier: BSD-3-Clause
#include "CrossingLog.h"

namespace toss::test {
namespace {

using SameBytes = CrossingLog;

TEST_F(SameBytes, WhateverTheNumberOfThreads) {
  const fs::path one = map(rawlog(), "one", "--threads 1 --live-labels --instances");
  const fs::path two = map(rawlog(), "two", "--threads 2 --live-labels --instances");
  const fs::path five = map(rawlog(), "five", "--threads 5 --live-labels --instances");
  expectSameFiles(one, two);
  expectSameFiles(one, five);
}

TEST_F(SameBytes, WhenRunAgainIntoTheSameFolder) {
  const fs::path first = map(rawlog(), "first"), second = map(rawlog(), "second");
  runWell("map " + quoted(rawlog()) + " --no-snapshots --out " + quoted(second));
  expectSameFiles(first, second);
}

TEST_F(SameBytes, WhenTheConfigurationIsFedBack) {
  const fs::path first = map(rawlog(), "tuned", "--no-snapshots --set map.voxel_size=0.17");
  const fs::path again =
      map(rawlog(), "again", "--no-snapshots --config " + quoted(first / "config.ini"));
  expectSameFiles(first, again);
}

TEST_F(SameBytes, WhetherFolderOrTheRawlogImportedFromIt) {
  runWell("simulate crossing " + quoted(in("kitti")) + " --format kitti --pose-noise 1");
  runWell("import kitti " + quoted(in("kitti")) + " " + quoted(in("imported.rawlog")));
  runWell("import kitti --gz " + quoted(in("kitti")) + " " + quoted(in("packed.rawlog")));
  const fs::path folder = map(in("kitti"), "of_folder");
  expectSameResult(folder, map(in("imported.rawlog"), "of_rawlog"));
  expectSameResult(folder, map(in("packed.rawlog"), "of_gz"));
}

TEST_F(SameBytes, OfSimulatedLogs) {
  runWell("simulate crossing " + quoted(in("again.rawlog")));
  EXPECT_TRUE(readBytes(in("again.rawlog")) == readBytes(rawlog()));
  runWell("simulate crossing " + quoted(in("other.rawlog")) + " --seed 2");
  EXPECT_FALSE(readBytes(in("other.rawlog")) == readBytes(rawlog()));
}

}  // namespace
}  // namespace toss::test
