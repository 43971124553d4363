// SPDX-License-Identifier: BSD-3-Clause
// Rings, times and beams travel beside the rawlog, which stays one of stock classes.
#include <InputFixtures.h>
#include <mrpt/obs/CRawlog.h>
#include <toss/rawlog/RawlogWriter.h>
#include <toss/rawlog/SweepFolder.h>

#include <memory>
#include <stdexcept>

namespace toss::test {
namespace {

using ::testing::HasSubstr;

PosedScan scanWithSweep(std::uint64_t index) {
  PosedScan scan = makeScan(index);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    scan.points.ring.push_back(static_cast<std::uint16_t>((7 * i + index) % 300));
    scan.points.time.push_back(-0.05f + 0.0017f * static_cast<float>(i));
  }
  SensorModel beams{"OS9-3", {0.3f, 0.1f, -0.7f}, 77, 0.4f, 111.0f};
  scan.beams = std::make_shared<const SensorModel>(beams);
  scan.sensorLabel = "roof lidar/1";
  scan.motionCompensated = index == 1;
  return scan;
}

void writeLog(const fs::path& file, const std::vector<PosedScan>& scans) {
  RawlogWriter writer(file);
  for (const PosedScan& scan : scans) writer.write(scan);
  writer.commit();
}

TEST(SweepFolder, ScansComeBackAsTheyWent) {
  TemporaryFolder folder;
  writeLog(folder / "a.rawlog", {scanWithSweep(0), scanWithSweep(1)});
  InputOptions asStored;
  asStored.deskew = Deskew::Off;
  const ReadInput read = readInput(folder / "a.rawlog", asStored);
  ASSERT_EQ(read.scans.size(), 2u);
  EXPECT_TRUE(read.report.warnings.empty());
  for (std::size_t i = 0; i < 2; ++i) {
    const PosedScan expected = scanWithSweep(i);
    expectSameScan(read.scans[i], expected);
    EXPECT_EQ(read.scans[i].points.ring, expected.points.ring);
    EXPECT_TRUE(sameBits(read.scans[i].points.time, expected.points.time));
    EXPECT_EQ(read.scans[i].motionCompensated, i == 1);
    ASSERT_TRUE(read.scans[i].beams);
    EXPECT_EQ(read.scans[i].beams->name, "OS9-3");
    EXPECT_TRUE(sameBits(read.scans[i].beams->elevations, expected.beams->elevations));
    EXPECT_EQ(read.scans[i].beams->columns, 77);
    EXPECT_EQ(read.scans[i].beams->minRange, 0.4f);
    EXPECT_EQ(read.scans[i].beams->maxRange, 111.0f);
  }
}

TEST(SweepFolder, ItsFilesAreNamedByLabelAndTime) {
  EXPECT_EQ(sweepFileName("roof lidar/1", 1.6e9 + 0.25), "roof_lidar_1_1600000000.2500000.sweep");
  EXPECT_EQ(sweepFileName("OS1-64", 0.0), "OS1-64_0.0000000.sweep");
  EXPECT_EQ(sweepFileName("a", -0.25), "a_-1.7500000.sweep");
}

TEST(SweepFolder, StockProgramsReadTheRawlog) {
  TemporaryFolder folder;
  writeLog(folder / "a.rawlog", {scanWithSweep(0), scanWithSweep(1)});
  mrpt::obs::CRawlog rawlog;
  ASSERT_TRUE(rawlog.loadFromRawLogFile((folder / "a.rawlog").string()));
  ASSERT_EQ(rawlog.size(), 4u);
  const auto cloud =
      std::dynamic_pointer_cast<mrpt::obs::CObservationPointCloud>(rawlog.getAsGeneric(1));
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->pointcloud->size(), 50u);
}

TEST(SweepFolder, PlainScansMakeNone) {
  TemporaryFolder folder;
  writeLog(folder / "a.rawlog", {makeScan(0)});
  EXPECT_FALSE(fs::exists(folder / "a_sweeps"));
  EXPECT_FALSE(readInput(folder / "a.rawlog").scans.at(0).beams);
}

TEST(SweepFolder, LogsThatWereThinnedOutKeepTheirOwn) {
  TemporaryFolder folder;
  writeLog(folder / "a.rawlog", {scanWithSweep(0), scanWithSweep(1), scanWithSweep(2)});
  const PosedScan last = scanWithSweep(2);
  writeObjects(folder / "a.rawlog", {poseObservation(last.time, last.mapFromSensor),
                                     cloudObservation(last.time, last, "roof lidar/1")});
  EXPECT_EQ(readInput(folder / "a.rawlog").scans.at(0).points.ring, last.points.ring);
}

TEST(SweepFolder, SaysWhatIsMissingOrDamaged) {
  TemporaryFolder folder;
  const fs::path log = folder / "a.rawlog", sweeps = folder / "a_sweeps";
  writeLog(log, {scanWithSweep(0), scanWithSweep(1)});
  const fs::path file = sweeps / sweepFileName("roof lidar/1", scanWithSweep(0).time);
  const std::string bytes = readBytes(file);
  for (const std::size_t cut :
       {std::size_t{0}, std::size_t{9}, std::size_t{16}, bytes.size() - 1}) {
    writeBytes(file, bytes.substr(0, cut));
    EXPECT_THAT(userErrorOf([&] { readInput(log); }), HasSubstr("is damaged")) << cut;
  }
  std::string notANumber = bytes;
  notANumber.replace(bytes.size() - 4, 4, "\xff\xff\xff\x7f");
  writeBytes(file, notANumber);
  EXPECT_THAT(userErrorOf([&] { readInput(log); }), HasSubstr("a time that is no number"));
  fs::remove(file);
  EXPECT_THAT(readInput(log).report.warnings.at(0), HasSubstr("1 scans have no rings and times"));
  writeBytes(sweeps / "sensors.json", "{\"roof lidar/1\": {\"model\": 3}}");
  EXPECT_THAT(userErrorOf([&] { readInput(log); }), HasSubstr("sensors.json: is damaged"));
}

TEST(SweepFolder, RefusesTheFolderOfAnotherLog) {
  TemporaryFolder folder;
  writeLog(folder / "a.rawlog", {scanWithSweep(0)});
  RawlogWriter plain(folder / "a.rawlog");
  EXPECT_THAT(userErrorOf([&] { plain.write(makeScan(0)); }),
              HasSubstr("a_sweeps: holds rings and times of an earlier log"));
  const PosedScan other = makeScan(0, 20);
  writeObjects(folder / "a.rawlog", {poseObservation(other.time, other.mapFromSensor),
                                     cloudObservation(other.time, other, "roof lidar/1")});
  EXPECT_THAT(userErrorOf([&] { readInput(folder / "a.rawlog"); }),
              HasSubstr("is of a scan of 50 points, but the log's has 20"));
}

TEST(SweepFolder, AsksForOneRingPerPoint) {
  TemporaryFolder folder;
  PosedScan scan = makeScan(0);
  scan.points.ring = {1, 2, 3};
  RawlogWriter writer(folder / "a.rawlog");
  EXPECT_THROW(writer.write(scan), std::logic_error);
}

}  // namespace
}  // namespace toss::test
