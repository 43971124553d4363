// SPDX-License-Identifier: BSD-3-Clause
// Captures that can not be imported: one line that says why and what to do, and no rawlog.
#include <InputFixtures.h>
#include <toss/import/VelodyneImport.h>

#include "VelodyneFixtures.h"

namespace toss::test {
namespace {

using ::testing::HasSubstr;

class VelodyneErrors : public ::testing::Test {
 protected:
  std::string errorOf(const std::string& capture) {
    writeBytes(folder / "a.pcap", capture);
    const std::string error = userErrorOf([&] { import(); });
    EXPECT_EQ(error.find('\n'), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "a.rawlog"));
    return error;
  }
  std::string errorOf(const DataPacket& packet) {
    return errorOf(pcapOf(turningFrames(9, packet)));
  }

  VelodyneImportResult import() {
    return importVelodyne(folder / "a.pcap", folder / "a.rawlog", options);
  }

  /// A calibration in the ROS driver's form; lasers 0.4 degrees apart.
  std::string calibrationText(int lasers) const {
    std::string text = "lasers:\n";
    for (int i = 0; i < lasers; ++i)
      text += "- {dist_correction: 1.25, horiz_offset_correction: 0.026, laser_id: " +
              std::to_string(i) +
              ", rot_correction: 0.0, vert_correction: " + std::to_string(0.04 - 0.007 * i) +
              ", vert_offset_correction: 0.2}\n";
    return text + "num_lasers: " + std::to_string(lasers) + "\n";
  }

  TemporaryFolder folder;
  VelodyneImportOptions options = [] {
    VelodyneImportOptions made;
    made.model = "VLP16";
    return made;
  }();
};

TEST_F(VelodyneErrors, AnotherModel) {
  DataPacket packet;
  packet.factoryByte = 0x21;
  EXPECT_THAT(errorOf(packet), HasSubstr("are of model HDL-32E, not of --model VLP16"));
  packet.factoryByte = 0x28;
  EXPECT_THAT(errorOf(packet), HasSubstr("VLP-32C, not of --model VLP16; this model can't be"));
  packet.factoryByte = 0x24;
  EXPECT_THAT(errorOf(packet), HasSubstr("Puck Hi-Res, which has other beams"));
  packet.lowerBank = true;
  EXPECT_THAT(errorOf(packet), HasSubstr("HDL-64E"));
  options.model = "VLP-16";
  EXPECT_THAT(errorOf(packet), HasSubstr("did you mean 'VLP16'?"));
  packet = {};
  packet.factoryByte = 0x23;
  options.model = "VLP16";
  EXPECT_EQ(errorOf(pcapOf({})).empty(), false);
  writeBytes(folder / "a.pcap", pcapOf(turningFrames(9, packet)));
  EXPECT_EQ(import().packets, 9u) << "a Puck LITE is like a VLP-16";
}

TEST_F(VelodyneErrors, NoSuchPackets) {
  EXPECT_THAT(errorOf(std::string("no capture at all, but a text that is long enough")),
              HasSubstr("a.pcap"));
  EXPECT_THAT(errorOf(pcapOf({ethernetOf(ipv4Of(udpOf(std::string(800, 'x'))))})),
              HasSubstr("no data packets of a Velodyne sensor, but others, most of them of 800"));
  EXPECT_THAT(errorOf(pcapOf({ethernetOf(ipv4Of(udpOf(std::string(1206, 'x'))))})),
              HasSubstr("no data packets"));
  options.port = 2369;
  EXPECT_THAT(errorOf(DataPacket()), HasSubstr("sensor to port 2369"));
}

TEST_F(VelodyneErrors, SeveralSensors) {
  std::vector<std::string> frames = turningFrames(9);
  frames.push_back(frameOf(DataPacket(), 2370));
  EXPECT_THAT(errorOf(pcapOf(frames)),
              HasSubstr("9 from 192.0.2.1 to port 2368, 1 from 192.0.2.1"));
  options.port = 2370;
  writeBytes(folder / "a.pcap", pcapOf(frames));
  EXPECT_EQ(import().packets, 1u);
  options.port = 0;
  options.source = "192.0.2.9";
  fs::remove(folder / "a.rawlog");
  EXPECT_THAT(errorOf(pcapOf(frames)), HasSubstr("sensor from 192.0.2.9"));
}

TEST_F(VelodyneErrors, ACaptureThatIsCutGivesWhatItHolds) {
  const std::string whole = pcapOf(turningFrames(9)), next = pcapngOf(turningFrames(9));
  writeBytes(folder / "a.pcap", whole.substr(0, whole.size() - 700));
  const VelodyneImportResult result = import();
  EXPECT_EQ(result.packets, 8u);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0], HasSubstr("a.pcap"));
  writeBytes(folder / "a.pcap", next);
  EXPECT_EQ(import().packets, 9u);
  for (std::size_t size = 0; size < 2000; size += 111) {
    writeBytes(folder / "a.pcap", whole.substr(0, size));
    userErrorOf([&] { import(); });
    writeBytes(folder / "a.pcap", next.substr(0, size));
    userErrorOf([&] { import(); });
  }
}

TEST_F(VelodyneErrors, AnHdl64NeedsItsCalibration) {
  DataPacket packet;
  packet.lowerBank = true;
  options.model = "HDL64";
  EXPECT_THAT(errorOf(packet), HasSubstr("--calibration"));
  options.calibration = folder / "own.yaml";
  EXPECT_THAT(errorOf(packet), HasSubstr("own.yaml: is no file"));
  writeBytes(options.calibration, "lasers: [");
  EXPECT_THAT(errorOf(packet), HasSubstr("own.yaml: is no calibration"));
  writeBytes(options.calibration, calibrationText(32));
  EXPECT_THAT(errorOf(packet), HasSubstr("describes 32 lasers, but --model HDL64 has 64"));
  writeBytes(folder / "own.xml", "<boost_serialization/>");
  options.calibration = folder / "own.xml";
  EXPECT_THAT(errorOf(packet), HasSubstr("own.xml: is no calibration"));

  options.calibration = folder / "own.yaml";
  writeBytes(options.calibration, calibrationText(64));
  writeBytes(folder / "a.pcap", pcapOf(turningFrames(9, packet)));
  import();
  const auto scan = observationsIn<mrpt::obs::CObservationVelodyneScan>(folder / "a.rawlog").at(0);
  scan->generatePointCloud();
  ASSERT_GE(scan->point_cloud.size(), 9u * 12u * 16u);
  // The first laser: 5 m + 1.25 m at 0.04 rad, straight ahead, its origin 0.2 m above and 0.026 m
  // beside the axis.
  EXPECT_NEAR(scan->point_cloud.x[0], 6.25 * std::cos(0.04) + 0.2 * std::sin(0.04), 0.02);
  EXPECT_NEAR(scan->point_cloud.z[0], 6.25 * std::sin(0.04) + 0.2 * std::cos(0.04), 0.02);
}

TEST_F(VelodyneErrors, LabelsOfAnotherLogAreInTheWay) {
  fs::create_directories(folder / "a_labels");
  EXPECT_THAT(errorOf(DataPacket()), HasSubstr("a_labels: holds labels of an earlier log"));
}

}  // namespace
}  // namespace toss::test
