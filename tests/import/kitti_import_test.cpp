// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <toss/import/KittiImport.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/LabelFile.h>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint32_t> labelsOf(std::size_t scan) {
  return std::vector<std::uint32_t>(50, static_cast<std::uint32_t>(scan) << 16 | 252u);
}

class KittiImport : public ::testing::Test {
 protected:
  void SetUp() override {
    KittiFolderWriter writer(sequence, poseOf(0.1, -0.2, 0.3, 1.5, 0.02, -1.4));
    for (std::size_t i = 0; i < 6; ++i) writer.write(makeScan(i), labelsOf(i));
    writer.commit();
  }

  TemporaryFolder folder;
  fs::path sequence = folder / "sequence", rawlog = folder / "out.rawlog";
};

TEST_F(KittiImport, GivesTheSameScansAsTheFolder) {
  for (const bool gz : {false, true}) {
    KittiImportOptions options;
    options.gz = gz;
    const KittiImportResult result = importKitti(sequence, rawlog, options);
    EXPECT_EQ(result.scans, 6u);
    EXPECT_EQ(result.labelled, 6u);
    const ReadInput fromFolder = readInput(sequence), fromRawlog = readInput(rawlog);
    ASSERT_EQ(fromRawlog.scans.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
      SCOPED_TRACE(i);
      expectSameScan(fromRawlog.scans[i], fromFolder.scans[i]);
      EXPECT_EQ(fromRawlog.scans[i].index, fromFolder.scans[i].index);
      EXPECT_EQ(fromRawlog.scans[i].sensorLabel, fromFolder.scans[i].sensorLabel);
      EXPECT_EQ(fromRawlog.scans[i].sensorModel, fromFolder.scans[i].sensorModel);
      EXPECT_EQ(readLabels(labelPath(labelsFolderOf(rawlog), i), 50), labelsOf(i));
    }
  }
}

TEST_F(KittiImport, TakesARangeAndNumbersItAnew) {
  KittiImportOptions options;
  options.from = 2;
  options.to = 4;
  double progress = 0.0;
  options.progress = [&](double share) {
    EXPECT_GT(share, progress);
    progress = share;
  };
  EXPECT_EQ(importKitti(sequence, rawlog, options).scans, 3u);
  EXPECT_NEAR(progress, 5.0 / 6.0, 1e-12);
  const ReadInput read = readInput(rawlog);
  ASSERT_EQ(read.scans.size(), 3u);
  EXPECT_TRUE(sameBits(read.scans[0].points.x, makeScan(2).points.x));
  EXPECT_EQ(read.scans[0].index, 0u);
  EXPECT_EQ(readLabels(labelPath(labelsFolderOf(rawlog), 0), 50), labelsOf(2));
  EXPECT_FALSE(fs::exists(labelPath(labelsFolderOf(rawlog), 3)));
}

TEST_F(KittiImport, WorksWithoutLabels) {
  fs::remove_all(sequence / "labels");
  EXPECT_EQ(importKitti(sequence, rawlog).labelled, 0u);
  EXPECT_TRUE(labelsFolderOf(rawlog).empty());
}

TEST_F(KittiImport, LeavesNothingBehindWhenItFails) {
  writeBytes(sequence / "velodyne/000004.bin", "cut");
  EXPECT_THAT(userErrorOf([&] { importKitti(sequence, rawlog); }), HasSubstr("000004.bin"));
  writeBytes(sequence / "velodyne/000004.bin", "");
  EXPECT_THAT(userErrorOf([&] { importKitti(sequence, rawlog); }), HasSubstr("000004.label"));
  KittiImportOptions options;
  options.from = 100;
  EXPECT_THAT(userErrorOf([&] { importKitti(sequence, rawlog, options); }), HasSubstr("--from"));
  EXPECT_THAT(userErrorOf([&] { importKitti(folder / "none", rawlog); }),
              HasSubstr("is no folder"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / ""), {}), 1);
}

TEST(KittiImportData, RealScansStayAsTheyAre) {
  const fs::path data = dataFolder() / "kitti-tracking-0000";
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  TemporaryFolder folder;
  KittiImportOptions options;
  options.from = 40;
  options.to = 44;
  EXPECT_EQ(importKitti(data, folder / "a.rawlog", options).labelled, 5u);
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 5u);
  const auto source = openScans(data, {});
  PosedScan scan;
  while (source->next(scan) && scan.index <= 44) {
    if (scan.index < 40) continue;
    const PosedScan& imported = read.scans[scan.index - 40];
    expectSameScan(imported, scan);
    EXPECT_EQ(imported.sensorModel, "HDL-64E");
    EXPECT_EQ(readBytes(labelPath(labelsFolderOf(folder / "a.rawlog"), scan.index - 40)),
              readBytes(labelPath(data / "labels", scan.index)));
  }
}

}  // namespace
}  // namespace toss::test
