// SPDX-License-Identifier: BSD-3-Clause
// Captures of Velodyne sensors become rawlogs that hold every packet, in revolutions.
#include <InputFixtures.h>
#include <mrpt/obs/CObservationGPS.h>
#include <toss/import/VelodyneImport.h>

#include "VelodyneFixtures.h"

namespace toss::test {
namespace {

using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationVelodyneScan;

constexpr std::size_t kFileHeader = 24, kFrameHeader = 16, kUdpHeader = 42;

VelodyneImportOptions optionsFor(const std::string& model) {
  VelodyneImportOptions options;
  options.model = model;
  return options;
}

/// The data packets of a real capture one after another, by the fixed places of their headers.
std::string dataPacketsIn(const std::string& pcap) {
  std::string bytes;
  for (std::size_t at = kFileHeader; at + kFrameHeader < pcap.size();) {
    std::uint32_t length = 0;
    std::memcpy(&length, pcap.data() + at + 8, sizeof length);
    if (length == kUdpHeader + 1206) bytes += pcap.substr(at + kFrameHeader + kUdpHeader, 1206);
    at += kFrameHeader + length;
  }
  return bytes;
}

std::string packetsOf(const std::vector<CObservationVelodyneScan::Ptr>& scans) {
  std::string bytes;
  for (const auto& scan : scans)
    for (const auto& packet : scan->scan_packets)
      bytes.append(reinterpret_cast<const char*>(&packet), sizeof packet);
  return bytes;
}

std::vector<CObservationVelodyneScan::Ptr> importFrames(const fs::path& folder,
                                                        const std::vector<std::string>& frames) {
  writeBytes(folder / "a.pcap", pcapOf(frames));
  importVelodyne(folder / "a.pcap", folder / "a.rawlog", optionsFor("VLP16"));
  return observationsIn<CObservationVelodyneScan>(folder / "a.rawlog");
}

struct RealCase {
  const char *file, *model;
  std::size_t scans, lasers, positions;
  double firstTime;
  bool satelliteTime;
};

class RealCapture : public ::testing::TestWithParam<RealCase> {};

TEST_P(RealCapture, KeepsEveryPacketInRevolutions) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  TemporaryFolder folder;
  const fs::path capture = dataFolder() / "velodyne" / GetParam().file;
  const VelodyneImportResult result =
      importVelodyne(capture, folder / "a.rawlog", optionsFor(GetParam().model));
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_EQ(result.satelliteTime, GetParam().satelliteTime);
  EXPECT_EQ(result.positions, GetParam().positions);

  const auto scans = observationsIn<CObservationVelodyneScan>(folder / "a.rawlog");
  ASSERT_EQ(scans.size(), GetParam().scans);
  EXPECT_EQ(result.scans, scans.size());
  EXPECT_TRUE(packetsOf(scans) == dataPacketsIn(readBytes(capture)));
  for (const auto& scan : scans) {
    EXPECT_EQ(scan->calibration.laser_corrections.size(), GetParam().lasers);
    for (std::size_t i = 1; i < scan->scan_packets.size(); ++i)
      EXPECT_GT(scan->scan_packets[i].blocks[0].rotation(),
                scan->scan_packets[i - 1].blocks[0].rotation());
  }
  EXPECT_NEAR(fromMrptTime(scans[0]->timestamp), GetParam().firstTime, 1e-6);
  EXPECT_EQ(scans[0]->has_satellite_timestamp, GetParam().satelliteTime);
}

// VLP-16: 2016-01-21 08:00 UTC and 1082.340595 s, as its receiver and its clock say.
INSTANTIATE_TEST_SUITE_P(Sensors, RealCapture,
                         ::testing::Values(RealCase{"sample_velodyne_vlp16_gps.pcap", "VLP16", 5,
                                                    16, 57, 1453363200.0 + 1082.340595, true},
                                           RealCase{"sample_velodyne_hdl32.pcap", "HDL32", 4, 32, 0,
                                                    1319768048.284089, false}));

TEST(VelodyneImport, PositionsAreThoseOfTheReceiver) {
  if (dataFolder().empty()) GTEST_SKIP() << "real data is absent, set TOSS_TEST_DATA";
  TemporaryFolder folder;
  importVelodyne(dataFolder() / "velodyne/sample_velodyne_vlp16_gps.pcap", folder / "a.rawlog",
                 optionsFor("VLP16"));
  const auto positions = observationsIn<CObservationGPS>(folder / "a.rawlog");
  ASSERT_EQ(positions.size(), 57u);
  const auto& rmc = positions[0]->getMsgByClass<mrpt::obs::gnss::Message_NMEA_RMC>().fields;
  EXPECT_NEAR(rmc.latitude_degrees, 36.0 + 49.7478558 / 60.0, 1e-12);
  EXPECT_NEAR(rmc.longitude_degrees, -(2.0 + 24.4542928 / 60.0), 1e-12);
  EXPECT_EQ(rmc.validity_char, 'A');
  EXPECT_EQ(rmc.UTCTime.hour, 8);
  EXPECT_EQ(rmc.positioning_mode, 'A');
  EXPECT_TRUE(positions[0]->has_satellite_timestamp);
  EXPECT_NEAR(fromMrptTime(positions[0]->timestamp), 1453363200.0 + 1082.342001, 1e-6);
}

TEST(VelodyneImport, CutsWhereTheAzimuthPassesZero) {
  TemporaryFolder folder;
  DataPacket first;
  first.rotation = 18000;
  const auto scans = importFrames(folder / "", turningFrames(200, first));
  ASSERT_EQ(scans.size(), 4u);
  EXPECT_EQ(scans[0]->scan_packets.size(), 38u);
  EXPECT_EQ(scans[1]->scan_packets.size(), 75u);
  EXPECT_EQ(scans[2]->scan_packets.size(), 75u);
  EXPECT_EQ(scans[3]->scan_packets.size(), 12u);
}

TEST(VelodyneImport, LatePacketsGoToTheirPlace) {
  TemporaryFolder folder;
  std::vector<std::string> frames = turningFrames(150), inOrder = frames;
  std::swap(frames[20], frames[21]);
  std::swap(frames[74], frames[75]);
  const auto scans = importFrames(folder / "", frames);
  std::string expected;
  for (const std::string& frame : inOrder) expected += frame.substr(frame.size() - 1206);
  EXPECT_TRUE(packetsOf(scans) == expected);
  EXPECT_EQ(scans.size(), 2u);
}

TEST(VelodyneImport, TheFullHourIsNoLatePacket) {
  TemporaryFolder folder;
  DataPacket first;
  first.microseconds = 3'600'000'000u - 50'000u;
  const auto scans = importFrames(folder / "", turningFrames(75, first));
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0]->scan_packets.front().gps_timestamp(), first.microseconds);
  EXPECT_EQ(scans[0]->scan_packets.back().gps_timestamp(), 74u * 1327u - 50'000u);
}

TEST(VelodyneImport, APauseEndsARevolution) {
  TemporaryFolder folder;
  std::vector<std::string> frames = turningFrames(10);
  DataPacket later;
  later.rotation = 10000;
  later.microseconds = 7'000'000;
  for (const std::string& frame : turningFrames(10, later)) frames.push_back(frame);
  DataPacket clockSetBack;
  clockSetBack.rotation = 20000;
  clockSetBack.microseconds = 2'000'000;
  for (const std::string& frame : turningFrames(10, clockSetBack)) frames.push_back(frame);
  EXPECT_EQ(importFrames(folder / "", frames).size(), 3u);
}

TEST(VelodyneImport, KeepsTheSensorsPlaceAndLabel) {
  TemporaryFolder folder;
  writeBytes(folder / "a.pcap", pcapOf(turningFrames(20)));
  VelodyneImportOptions options = optionsFor("VLP16");
  options.label = "left";
  options.robotFromSensor = poseOf(0.1, 0.2, 1.5, 0.3);
  options.gz = true;
  importVelodyne(folder / "a.pcap", folder / "a.rawlog", options);
  const auto scan = observationsIn<CObservationVelodyneScan>(folder / "a.rawlog").at(0);
  EXPECT_EQ(scan->sensorLabel, "left");
  EXPECT_TRUE(fromMrpt(scan->sensorPose).isApprox(options.robotFromSensor, 1e-12));
}

TEST(VelodyneImport, TwoReturnsPerFiringStay) {
  TemporaryFolder folder;
  DataPacket dual;
  dual.mode = 0x39;
  writeBytes(folder / "a.pcap", pcapOf(turningFrames(20, dual)));
  const auto result = importVelodyne(folder / "a.pcap", folder / "a.rawlog", optionsFor("VLP16"));
  EXPECT_TRUE(result.dualReturn);
  const auto scan = observationsIn<CObservationVelodyneScan>(folder / "a.rawlog").at(0);
  EXPECT_EQ(scan->scan_packets.size(), 20u);
  EXPECT_EQ(scan->scan_packets[7].laser_return_mode, 0x39);
}

TEST(VelodyneImport, TimesOfTheReceiverAreTakenOnlyIfTheyFit) {
  TemporaryFolder folder;
  const std::string sentence = "GPRMC,235959.00,A,4800.0000,N,01130.0000,E,0.0,0.0,310121,,,A";
  DataPacket first;
  first.microseconds = 3'599'400'000u;
  const auto importWith = [&](const std::string& rmc, std::uint32_t clock) {
    std::vector<std::string> frames = turningFrames(900, first);
    frames.insert(frames.begin() + 100, positionFrame(clock, rmc));
    writeBytes(folder / "a.pcap", pcapOf(frames));
    return importVelodyne(folder / "a.pcap", folder / "a.rawlog", optionsFor("VLP16"));
  };
  EXPECT_TRUE(importWith(sentence, 3'599'500'000u).satelliteTime);
  const auto scans = observationsIn<CObservationVelodyneScan>(folder / "a.rawlog");
  EXPECT_NEAR(fromMrptTime(scans.front()->timestamp), 1612137599.4, 1e-6);
  // The sensor's clock and the day begin anew on the way.
  EXPECT_NEAR(fromMrptTime(scans.back()->timestamp), 1612137599.4 + 825 * 1327e-6, 1e-6);

  const auto unset = importWith(sentence, 12'000'000u);
  EXPECT_FALSE(unset.satelliteTime);
  EXPECT_THAT(unset.warnings.at(0), ::testing::HasSubstr("clock is not set by its GPS receiver"));
  std::string noFix = sentence;
  noFix.replace(noFix.find(",A,"), 3, ",V,");
  EXPECT_THAT(importWith(noFix, 3'599'500'000u).warnings.at(0), ::testing::HasSubstr("no fix"));
}

}  // namespace
}  // namespace toss::test
