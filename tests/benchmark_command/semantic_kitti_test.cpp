// SPDX-License-Identifier: BSD-3-Clause
#include <toss/simulation/SimulateTo.h>

#include "InputFixtures.h"

namespace toss::test {
namespace {

/// Sequence 01 in SemanticKITTI's layout with scans 148 to 171, made by the simulator; of these 150
/// to 171 are in the benchmark's range.
class SemanticKittiFolder : public testing::Test {
 protected:
  static constexpr int kFirst = 148, kScans = 24;

  void SetUp() override {
    SimulationOptions options;
    options.scene = "crossing", options.frames = kScans, options.sensor = "HDL-32E";
    simulateTo(folder_ / "made", LogFormat::Kitti, options);
    const fs::path sequence = folder_ / "sequences" / "01";
    for (const char* name : {"velodyne", "labels"}) fs::create_directories(sequence / name);
    for (int s = 0; s < kScans; ++s) {
      fs::rename(scanFile(folder_ / "made", "velodyne", s, ".bin"),
                 scanFile(sequence, "velodyne", kFirst + s, ".bin"));
      fs::rename(scanFile(folder_ / "made", "labels", s, ".label"),
                 scanFile(sequence, "labels", kFirst + s, ".label"));
    }
    fs::copy(folder_ / "made" / "calib.txt", sequence / "calib.txt");
    shiftLines("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0");
    writeTimes(sequence / "times.txt");
  }

  static fs::path scanFile(const fs::path& sequence, const char* folder, int scan,
                           const char* extension) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06d%s", scan, extension);
    return sequence / folder / name;
  }

  /// Copies a file of one line per scan, with kFirst further lines before it.
  void shiftLines(const char* name, const char* line) {
    std::ofstream out(folder_ / "sequences" / "01" / name);
    for (int i = 0; i < kFirst; ++i) out << line << "\n";
    out << readBytes(folder_ / "made" / name);
  }

  static void writeTimes(const fs::path& file) {
    std::ofstream out(file);
    for (int i = 0; i < kFirst + kScans; ++i) out << 0.1 * i << "\n";
  }

  int run(const std::string& folder) const {
    const std::string command = "'" TOSS_PROGRAM "' -q benchmark semantickitti '" + folder +
                                "' --out '" + (folder_ / "table.md").string() + "' 2>'" +
                                (folder_ / "errors").string() + "'";
    return std::system(command.c_str());
  }

  TemporaryFolder folder_;
};

TEST_F(SemanticKittiFolder, IsScoredBesideThePublishedRows) {
  ASSERT_EQ(run((folder_ / "").string()), 0) << readBytes(folder_ / "errors");
  const std::string table = readBytes(folder_ / "table.md");
  EXPECT_THAT(table, testing::HasSubstr("| TOSS (published) | 99.87 / 80.70 / 0.893 |"));
  EXPECT_THAT(table, testing::HasSubstr("98.64 / 98.78 / 0.987"));
  EXPECT_THAT(table, testing::ContainsRegex(
                         "every scan\\*\\* \\| - \\| [0-9.]+ / (9[0-9.]+ / 0.9|100.00 / 1.0)"));
  EXPECT_THAT(table,
              testing::ContainsRegex(
                  "every second scan\\*\\* \\| - \\| [0-9.]+ / (9[0-9.]+ / 0.9|100.00 / 1.0)"));
  EXPECT_THAT(table, testing::HasSubstr("Sequence 05 is absent and was skipped."));
  EXPECT_THAT(table, testing::Not(testing::HasSubstr("Sequence 01 is absent")));
}

TEST_F(SemanticKittiFolder, WithoutAnySequenceIsAnErrorThatSaysSo) {
  EXPECT_NE(run((folder_ / "made").string()), 0);
  EXPECT_THAT(readBytes(folder_ / "errors"), testing::HasSubstr("none of the sequences"));
  EXPECT_FALSE(fs::exists(folder_ / "table.md"));
}

}  // namespace
}  // namespace toss::test
