// SPDX-License-Identifier: BSD-3-Clause
// Range images of sensors whose beams are known.
#include <InputFixtures.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <set>

namespace toss::test {
namespace {

using mrpt::obs::CObservationRotatingScan;
using mrpt::obs::CObservationVelodyneScan;
using ::testing::HasSubstr;

CObservationRotatingScan::Ptr rangeImage(int columns = 8) {
  auto scan = CObservationRotatingScan::Create();
  scan->timestamp = toMrptTime(1000.0);
  scan->sensorLabel = "front";
  scan->lidarModel = "Ouster OS1-64";
  scan->rowCount = 64;
  scan->columnCount = static_cast<std::uint16_t>(columns);
  scan->rangeImage.setZero(64, columns);
  scan->intensityImage.setZero(64, columns);
  scan->rangeResolution = 0.004;
  scan->startAzimuth = 0.0;
  scan->azimuthSpan = -2.0 * M_PI;
  scan->sweepDuration = 0.08;
  return scan;
}

ReadInput readScan(const mrpt::obs::CObservation::Ptr& observation, bool moving = false) {
  TemporaryFolder folder;
  std::vector<Object> objects = {poseObservation(1000.0, poseOf(0, 0, 0, 0)), observation};
  if (moving) objects.push_back(poseObservation(1000.1, poseOf(1, 0, 0, 0)));
  writeObjects(folder / "a.rawlog", objects);
  return readInput(folder / "a.rawlog");
}

TEST(RotatingScan, EveryPixelIsAPoint) {
  const auto image = rangeImage();
  image->rangeImage(0, 2) = 2500;
  image->intensityImage(0, 2) = 51;
  image->rangeImage(63, 5) = 1000;
  image->rangeImage(7, 7) = 10;
  const PosedScan scan = readScan(image).scans.at(0);
  ASSERT_EQ(scan.points.size(), 64u * 8u);
  EXPECT_EQ(scan.sensorModel, "OS1-64");
  const float top = sensorByName("OS1-64").elevations.front();
  // Clockwise by two of eight steps: to the right.
  EXPECT_NEAR(scan.points.x[2], 0.0f, 1e-5f);
  EXPECT_NEAR(scan.points.y[2], -10.0f * std::cos(top), 1e-5f);
  EXPECT_NEAR(scan.points.z[2], 10.0f * std::sin(top), 1e-5f);
  EXPECT_NEAR(scan.points.intensity[2], 0.2f, 1e-6f);
  EXPECT_NEAR(scan.points.time[2], 0.02f, 1e-7f);
  EXPECT_EQ(scan.points.ring[63 * 8 + 5], 63);
  EXPECT_LT(scan.points.z[63 * 8 + 5], -1.0f);
  EXPECT_EQ(scan.points.x[7 * 8 + 7], 0.0f) << "nearer than minRange";
}

TEST(RotatingScan, PartsOfATurnEndWithTheirLastColumn) {
  const auto image = rangeImage(5);
  image->startAzimuth = -0.4;
  image->azimuthSpan = 0.8;
  image->rangeImage(30, 4) = 2500;
  const PointCloud points = readScan(image).scans.at(0).points;
  EXPECT_NEAR(std::atan2(points.y[30 * 5 + 4], points.x[30 * 5 + 4]), 0.4f, 1e-6f);
}

TEST(RotatingScan, IsDeskewedByItsColumns) {
  const auto image = rangeImage();
  image->rangeImage(31, 4) = 2500;
  const ReadInput read = readScan(image, true);
  EXPECT_EQ(read.report.deskewed, 1u);
  // Half the sweep of 0.08 s at 10 m/s, seen behind.
  const double elevation = static_cast<double>(sensorByName("OS1-64").elevations[31]);
  EXPECT_NEAR(read.scans.at(0).points.x[31 * 8 + 4], -10.0 * std::cos(elevation) + 0.4, 1e-4);
}

/// Packets of a sensor that turns evenly, all returns at 4 m.
CObservationVelodyneScan::Ptr evenScan(const std::string& model, std::uint8_t factoryByte) {
  auto scan = CObservationVelodyneScan::Create();
  scan->timestamp = toMrptTime(1000.0);
  scan->calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model);
  for (unsigned number = 0; number < 30; ++number) {
    std::string bytes;
    for (unsigned block = 0; block < 12; ++block) {
      const unsigned rotation = 2000 + 40 * (12 * number + block);
      bytes +=
          {'\xff', '\xee', static_cast<char>(rotation & 255u), static_cast<char>(rotation >> 8)};
      for (int laser = 0; laser < 32; ++laser) bytes += {'\xd0', '\x07', '\x55'};
    }
    const std::uint32_t microseconds = 1327 * number;
    bytes.append(reinterpret_cast<const char*>(&microseconds), sizeof microseconds);
    bytes += {'\x37', static_cast<char>(factoryByte)};
    CObservationVelodyneScan::TVelodyneRawPacket packet;
    std::memcpy(static_cast<void*>(&packet), bytes.data(), sizeof packet);
    scan->scan_packets.push_back(packet);
  }
  return scan;
}

TEST(RotatingScan, ImagesThatMrptMadeOfPacketsShowTheSameDirections) {
  for (const auto& [model, byte] : {std::pair("VLP16", 0x22), std::pair("HDL32", 0x21)}) {
    SCOPED_TRACE(model);
    const auto packets = evenScan(model, static_cast<std::uint8_t>(byte));
    auto image = CObservationRotatingScan::Create();
    image->fromVelodyne(*packets);
    packets->generatePointCloud();
    const PosedScan scan = readScan(image).scans.at(0);
    // In the order of the packets: column after column, laser after laser.
    std::vector<Eigen::Vector3f> found;
    const auto rows = static_cast<std::size_t>(image->rowCount);
    const std::size_t columns = scan.points.size() / rows;
    for (std::size_t c = 0; c < columns; ++c)
      for (std::size_t r = 0; r < rows; ++r)
        if (const std::size_t i = r * columns + c; scan.points.x[i] != 0.0f)
          found.emplace_back(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
    const auto& expected = packets->point_cloud;
    ASSERT_EQ(found.size(), expected.size());
    std::set<std::uint16_t> rings(scan.points.ring.begin(), scan.points.ring.end());
    EXPECT_EQ(rings.size(), rows);
    // A column has one azimuth, while its lasers fire one after another: up to 0.4 degrees.
    for (std::size_t i = 0; i < found.size(); ++i)
      ASSERT_LT((found[i] - Eigen::Vector3f(expected.x[i], expected.y[i], expected.z[i])).norm(),
                4.0f * 0.0075f)
          << i;
  }
}

TEST(RotatingScan, SaysWhenTheBeamsAreNotKnown) {
  const auto image = rangeImage();
  image->lidarModel = "UNKNOWN_SCANNER";
  EXPECT_THAT(userErrorOf([&] { readScan(image); }),
              HasSubstr("object 1: its range image is of sensor 'UNKNOWN_SCANNER'"));
  image->lidarModel = "VLP-16";
  EXPECT_THAT(userErrorOf([&] { readScan(image); }),
              HasSubstr("of 64 rows is none of sensor VLP-16, which has 16"));
  image->lidarModel = "OS1-64";
  image->rangeResolution = 0.0;
  EXPECT_THAT(userErrorOf([&] { readScan(image); }), HasSubstr("rangeResolution"));
}

}  // namespace
}  // namespace toss::test
