// SPDX-License-Identifier: BSD-3-Clause
#include <InputFixtures.h>
#include <mrpt/obs/CObservationComment.h>
#include <toss/rawlog/InputSummary.h>
#include <toss/rawlog/KittiFolderWriter.h>

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

double pathLengthOf(std::size_t scans) {
  double length = 0.0;
  for (std::size_t i = 1; i < scans; ++i)
    length +=
        (makeScan(i).mapFromSensor.translation() - makeScan(i - 1).mapFromSensor.translation())
            .norm();
  return length;
}

TEST(InputSummary, CountsWhatARawlogHolds) {
  TemporaryFolder folder;
  auto objects = logOf(5);
  objects.push_back(cloudObservation(makeScan(9).time, makeScan(9, 7)));
  objects.push_back(mrpt::obs::CObservationComment::Create());
  writeObjects(folder / "a.rawlog", objects, true);
  fs::create_directories(folder / "a_labels");
  writeBytes(folder / "a_labels/000000.label", "");
  const InputSummary summary = summarizeInput(folder / "a.rawlog");
  EXPECT_EQ(summary.format, "rawlog (gz)");
  EXPECT_EQ(summary.bytes, fs::file_size(folder / "a.rawlog"));
  EXPECT_EQ(summary.scans, 6u);
  EXPECT_EQ(summary.scansWithoutPose, 1u);
  EXPECT_EQ(summary.poses, 5u);
  EXPECT_EQ(summary.labelFiles, 1u);
  EXPECT_NEAR(summary.pathLength, pathLengthOf(5), 1e-9);
  EXPECT_NEAR(summary.highest.x(), 5.3, 1e-9);
  EXPECT_NEAR(summary.lowest.y(), -2.8, 1e-9);
  ASSERT_EQ(summary.streams.size(), 3u);
  const StreamSummary& clouds = summary.streams[1];
  EXPECT_EQ(clouds.label, "lidar");
  EXPECT_EQ(clouds.points, 257u);
  EXPECT_EQ(clouds.fewestPoints, 7u);
  EXPECT_NEAR(summary.streams[2].rate(), 10.0, 1e-3);
  EXPECT_THAT(summary.warnings, IsEmpty());
  EXPECT_THAT(toText(summary), AllOf(HasSubstr("scans: 6, of them without a pose: 1"),
                                     HasSubstr("7 to 50 points"), HasSubstr("10.00 Hz")));
  EXPECT_THAT(toJson(summary), AllOf(HasSubstr("\"points\": 257"), HasSubstr("\"poses\": 5")));
}

TEST(InputSummary, TellsOfDamageAfterWhatIsGood) {
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", logOf(5), true);
  const std::string bytes = readBytes(folder / "a.rawlog");
  writeBytes(folder / "cut.rawlog", bytes.substr(0, bytes.size() - 100));
  const InputSummary summary = summarizeInput(folder / "cut.rawlog");
  EXPECT_GE(summary.scans, 4u);
  EXPECT_THAT(summary.warnings, Contains(HasSubstr("cut off")));
  writeBytes(folder / "text.rawlog", "text");
  EXPECT_THAT(userErrorOf([&] { summarizeInput(folder / "text.rawlog"); }),
              HasSubstr("is not a rawlog"));
}

TEST(InputSummary, WorksWithoutPoses) {
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", {cloudObservation(1.0, makeScan(0))});
  const InputSummary summary = summarizeInput(folder / "a.rawlog");
  EXPECT_EQ(summary.scans, 1u);
  EXPECT_EQ(summary.scansWithoutPose, 1u);
  EXPECT_EQ(summary.poses, 0u);
}

TEST(InputSummary, CountsWhatAFolderHolds) {
  TemporaryFolder folder;
  KittiFolderWriter writer(folder / "a");
  for (std::size_t i = 0; i < 4; ++i)
    writer.write(makeScan(i, 10 + i), std::vector<std::uint32_t>(10 + i));
  writer.commit();
  writeBytes(folder / "a/velodyne/000002.bin", "cut");
  const InputSummary summary = summarizeInput(folder / "a");
  EXPECT_EQ(summary.format, "KITTI folder");
  EXPECT_EQ(summary.scans, 4u);
  EXPECT_EQ(summary.labelFiles, 4u);
  EXPECT_EQ(summary.streams.at(0).points, 34u);
  EXPECT_NEAR(summary.streams.at(0).rate(), 10.0, 1e-3);
  EXPECT_NEAR(summary.pathLength, pathLengthOf(4), 1e-9);
  EXPECT_THAT(summary.warnings, Contains(HasSubstr("000002.bin")));
}

}  // namespace
}  // namespace toss::test
