// SPDX-License-Identifier: BSD-3-Clause
// What is written reads back as the same scans, from both formats.
#include <InputFixtures.h>
#include <toss/rawlog/KittiFolderWriter.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/RawlogWriter.h>

#include <stdexcept>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

std::vector<std::uint32_t> labelsOf(const PosedScan& scan) {
  std::vector<std::uint32_t> labels(scan.points.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = static_cast<std::uint32_t>(scan.index * 1000 + i) << 16 | 9u;
  return labels;
}

template <typename Writer>
void writeScans(Writer& writer, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) writer.write(makeScan(i), labelsOf(makeScan(i)));
  EXPECT_EQ(writer.scanCount(), count);
  writer.commit();
}

void expectWrittenScans(const fs::path& input, std::size_t count) {
  const ReadInput read = readInput(input);
  ASSERT_EQ(read.scans.size(), count);
  const fs::path labels = labelsFolderOf(input);
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    expectSameScan(read.scans[i], makeScan(i));
    EXPECT_EQ(readLabels(labelPath(labels, i), 50), labelsOf(makeScan(i)));
  }
}

TEST(RawlogWriter, WritesWhatReadsBackBitForBit) {
  TemporaryFolder folder;
  for (const bool gz : {false, true}) {
    const fs::path file = folder / (gz ? "gz.rawlog" : "plain.rawlog");
    RawlogWriter writer(file, gz);
    writeScans(writer, 4);
    EXPECT_EQ(readBytes(file).substr(0, 2) == "\x1f\x8b", gz);
    expectWrittenScans(file, 4);
  }
}

TEST(RawlogWriter, KeepsTheSensorsPlaceOnTheRobot) {
  TemporaryFolder folder;
  PosedScan scan = makeScan(3);
  scan.robotFromSensor = poseOf(0.2, 0.0, 1.5, 0.1, 0.2, 0.3);
  scan.sensorLabel = "ouster";
  RawlogWriter writer(folder / "a.rawlog");
  writer.write(scan);
  writer.commit();
  const PosedScan read = readInput(folder / "a.rawlog").scans.at(0);
  EXPECT_TRUE(read.mapFromSensor.isApprox(scan.mapFromSensor, 1e-13));
  EXPECT_TRUE(read.robotFromSensor.matrix() == scan.robotFromSensor.matrix());
  EXPECT_EQ(read.sensorLabel, "ouster");
}

TEST(RawlogWriter, LeavesNothingBehindWithoutCommit) {
  TemporaryFolder folder;
  {
    RawlogWriter writer(folder / "a.rawlog");
    writer.write(makeScan(0), labelsOf(makeScan(0)));
  }
  EXPECT_TRUE(fs::is_empty(folder / ""));
}

TEST(RawlogWriter, DoesNotMixItsScansWithOtherLabels) {
  TemporaryFolder folder;
  {
    RawlogWriter writer(folder / "a.rawlog");
    writeScans(writer, 3);
  }
  RawlogWriter again(folder / "a.rawlog");
  EXPECT_THAT(userErrorOf([&] { again.write(makeScan(0)); }), HasSubstr("a_labels: holds labels"));
  RawlogWriter labelled(folder / "a.rawlog");
  writeScans(labelled, 2);
  EXPECT_FALSE(fs::exists(labelPath(folder / "a_labels", 2)));
  expectWrittenScans(folder / "a.rawlog", 2);
}

TEST(RawlogWriter, RefusesWhatItCanNotWrite) {
  TemporaryFolder folder;
  EXPECT_THAT(userErrorOf([&] { RawlogWriter(folder / "nowhere/a.rawlog"); }),
              HasSubstr("its folder does not exist"));
  RawlogWriter writer(folder / "a.rawlog");
  EXPECT_THROW(writer.write(makeScan(0), {1, 2, 3}), std::logic_error);
}

TEST(KittiFolderWriter, WritesWhatReadsBackBitForBit) {
  TemporaryFolder folder;
  KittiFolderWriter writer(folder / "sequence");
  writeScans(writer, 4);
  expectWrittenScans(folder / "sequence", 4);
}

TEST(KittiFolderWriter, WritesPosesOfTheCamera) {
  TemporaryFolder folder;
  Eigen::Isometry3d cameraFromLidar = Eigen::Isometry3d::Identity();
  cameraFromLidar.matrix().topRows<3>() << 0, -1, 0, 0.1, 0, 0, -1, -0.2, 1, 0, 0, -0.3;
  KittiFolderWriter writer(folder / "sequence", cameraFromLidar);
  writer.write(makeScan(5));
  writer.commit();
  const PosedScan read = readInput(folder / "sequence").scans.at(0);
  EXPECT_TRUE(read.mapFromSensor.isApprox(makeScan(5).mapFromSensor, 1e-12));
  EXPECT_THAT(readBytes(folder / "sequence/calib.txt"), HasSubstr("Tr: 0 -1 0 0.1"));
}

TEST(KittiFolderWriter, KeepsWhatIsThere) {
  TemporaryFolder folder;
  writeBytes(folder / "sequence/notes.txt", "mine");
  EXPECT_THAT(userErrorOf([&] { KittiFolderWriter(folder / "sequence"); }),
              HasSubstr("is not empty"));
  { KittiFolderWriter abandoned(folder / "other"); }
  EXPECT_FALSE(fs::exists(folder / "other"));
  EXPECT_EQ(readBytes(folder / "sequence/notes.txt"), "mine");
}

TEST(MrptConversion, TimesComeBackAsTheyWent) {
  for (const double seconds : {0.0, 0.1, 12.3456789, 3.0e8 + 0.3, 9.5e8 + 0.1, 1.7e9 + 0.123457})
    EXPECT_EQ(fromMrptTime(toMrptTime(fromMrptTime(toMrptTime(seconds)))),
              fromMrptTime(toMrptTime(seconds)));
  EXPECT_NEAR(fromMrptTime(toMrptTime(0.12345678)), 0.1234568, 1e-12);
  EXPECT_EQ(toMrptTime(1.5), mrpt::Clock::fromDouble(1.5));
}

}  // namespace
}  // namespace toss::test
