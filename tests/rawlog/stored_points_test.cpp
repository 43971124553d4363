// SPDX-License-Identifier: BSD-3-Clause
// Points that lie elsewhere than in a point map of the log: external files, Velodyne packets.
#include <InputFixtures.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>

namespace toss::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Format = mrpt::obs::CObservationPointCloud::ExternalStorageFormat;

std::string kittiBytes(const PointCloud& points) {
  std::string bytes;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const float value : {points.x[i], points.y[i], points.z[i], points.intensity[i]})
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

/// A log with one scan, whose points lie in `externalName` of its folder of external files.
class ExternalPoints : public ::testing::TestWithParam<Format> {
 protected:
  void SetUp() override {
    scan = makeScan(0);
    auto cloud = cloudObservation(scan.time, scan);
    map = std::dynamic_pointer_cast<mrpt::maps::CPointsMapXYZI>(cloud->pointcloud);
    cloud->setAsExternalStorage("scan_0.dat", GetParam());
    writeObjects(log, {poseObservation(scan.time, scan.mapFromSensor), cloud});
  }

  void writeExternal() {
    fs::create_directories(external.parent_path());
    if (GetParam() == Format::KittiBinFile) writeBytes(external, kittiBytes(scan.points));
    if (GetParam() == Format::MRPT_Serialization) writeObjects(external, {map}, true);
    if (GetParam() != Format::PlainTextFile) return;
    std::ofstream text(external);
    text.precision(9);
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      text << scan.points.x[i] << " " << scan.points.y[i] << " " << scan.points.z[i] << " "
           << scan.points.intensity[i] << "\n";
  }

  TemporaryFolder folder;
  fs::path log = folder / "log.rawlog", external = folder / "log_Images/scan_0.dat";
  PosedScan scan;
  mrpt::maps::CPointsMapXYZI::Ptr map;
};

TEST_P(ExternalPoints, AreRead) {
  writeExternal();
  const ReadInput read = readInput(log);
  ASSERT_EQ(read.scans.size(), 1u);
  if (GetParam() == Format::PlainTextFile) {
    // MRPT reads "nan" as it likes; the others must be the same floats.
    ASSERT_EQ(read.scans[0].points.size(), scan.points.size());
    for (std::size_t i = 5; i < scan.points.size(); ++i)
      EXPECT_FLOAT_EQ(read.scans[0].points.x[i], scan.points.x[i]);
  } else {
    expectSameScan(read.scans[0], scan);
  }
}

TEST_P(ExternalPoints, AreMissed) {
  EXPECT_THAT(userErrorOf([&] { readInput(log); }),
              AllOf(HasSubstr("log.rawlog: object 1"), HasSubstr("scan_0.dat")));
}

/// Formats whose length can be checked: a text has none.
class ExternalBinaryPoints : public ExternalPoints {};

TEST_P(ExternalBinaryPoints, AreNeverLostInAFileThatIsCutOff) {
  writeExternal();
  const std::string bytes = readBytes(external);
  for (const std::size_t missing : {std::size_t{3}, std::size_t{100}, bytes.size() - 5}) {
    writeBytes(external, bytes.substr(0, bytes.size() - missing));
    EXPECT_THAT(userErrorOf([&] { readInput(log); }), HasSubstr("scan_0.dat"));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ExternalPoints,
                         ::testing::Values(Format::KittiBinFile, Format::MRPT_Serialization,
                                           Format::PlainTextFile));

INSTANTIATE_TEST_SUITE_P(Formats, ExternalBinaryPoints,
                         ::testing::Values(Format::KittiBinFile, Format::MRPT_Serialization));

constexpr std::size_t kPcapFileHeader = 24, kPcapPacketHeader = 16, kUdpHeader = 42;

/// The data packets of a pcap of a Velodyne sensor, as one observation.
mrpt::obs::CObservationVelodyneScan::Ptr velodyneScan(const std::string& pcap,
                                                      const std::string& model,
                                                      std::size_t packets) {
  using Scan = mrpt::obs::CObservationVelodyneScan;
  auto scan = Scan::Create();
  scan->calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model);
  scan->timestamp = toMrptTime(1000.0);
  scan->sensorLabel = "velodyne";
  for (std::size_t at = kPcapFileHeader;
       at + kPcapPacketHeader < pcap.size() && scan->scan_packets.size() < packets;) {
    std::uint32_t length = 0;
    std::memcpy(&length, pcap.data() + at + 8, sizeof length);
    if (length == kUdpHeader + Scan::PACKET_SIZE) {
      Scan::TVelodyneRawPacket packet;
      std::memcpy(static_cast<void*>(&packet), pcap.data() + at + kPcapPacketHeader + kUdpHeader,
                  Scan::PACKET_SIZE);
      scan->scan_packets.push_back(packet);
    }
    at += kPcapPacketHeader + length;
  }
  return scan;
}

struct VelodyneCase {
  const char *file, *model, *sensor;
  std::size_t packets;
  int rings;
};

class VelodynePoints : public ::testing::TestWithParam<VelodyneCase> {};

TEST_P(VelodynePoints, AreThoseOfMrptWithRingAndTime) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const std::string pcap = readBytes(dataFolder() / "velodyne" / GetParam().file);
  auto observation = velodyneScan(pcap, GetParam().model, GetParam().packets);
  ASSERT_EQ(observation->scan_packets.size(), GetParam().packets);
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", {poseObservation(1000.0, poseOf(0, 0, 0, 0)), observation});
  const ReadInput read = readInput(folder / "a.rawlog");
  ASSERT_EQ(read.scans.size(), 1u);
  const PointCloud& points = read.scans[0].points;

  observation->generatePointCloud();
  const auto& expected = observation->point_cloud;
  EXPECT_GT(points.size(), 5000u);
  EXPECT_TRUE(sameBits(points.x, expected.x));
  EXPECT_TRUE(sameBits(points.y, expected.y));
  EXPECT_TRUE(sameBits(points.z, expected.z));
  EXPECT_EQ(read.scans[0].sensorModel, GetParam().sensor);
  EXPECT_LE(*std::max_element(points.intensity.begin(), points.intensity.end()), 1.0f);

  ASSERT_EQ(points.ring.size(), points.size());
  EXPECT_LT(*std::max_element(points.ring.begin(), points.ring.end()), GetParam().rings);
  ASSERT_EQ(points.time.size(), points.size());
  const auto [first, last] = std::minmax_element(points.time.begin(), points.time.end());
  EXPECT_GE(*first, 0.0f);
  // 753.5 packets of a VLP-16, 1808 of an HDL-32E per second.
  EXPECT_NEAR(*last,
              static_cast<double>(GetParam().packets) / (GetParam().rings == 16 ? 753.5 : 1808.0),
              0.01);
}

TEST_P(VelodynePoints, HaveRingsFromTheTopDown) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  const std::string pcap = readBytes(dataFolder() / "velodyne" / GetParam().file);
  TemporaryFolder folder;
  writeObjects(folder / "a.rawlog", {poseObservation(1000.0, poseOf(0, 0, 0, 0)),
                                     velodyneScan(pcap, GetParam().model, GetParam().packets)});
  const PointCloud points = readInput(folder / "a.rawlog").scans.at(0).points;
  std::vector<double> lowest(static_cast<std::size_t>(GetParam().rings), 9.0);
  std::vector<double> highest(lowest.size(), -9.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double elevation = std::atan2(points.z[i], std::hypot(points.x[i], points.y[i]));
    lowest[points.ring[i]] = std::min(lowest[points.ring[i]], elevation);
    highest[points.ring[i]] = std::max(highest[points.ring[i]], elevation);
  }
  for (std::size_t ring = 1; ring < lowest.size(); ++ring)
    EXPECT_GE(lowest[ring - 1], highest[ring]) << "ring " << ring;
}

INSTANTIATE_TEST_SUITE_P(
    Models, VelodynePoints,
    ::testing::Values(VelodyneCase{"sample_velodyne_vlp16_gps.pcap", "VLP16", "VLP-16", 75, 16},
                      VelodyneCase{"sample_velodyne_hdl32.pcap", "HDL32", "HDL-32E", 180, 32}));

}  // namespace
}  // namespace toss::test
