// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <InputFixtures.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

/// Scans of real Velodyne sensors for tests.
namespace toss::test {

struct VelodyneCase {
  const char *file, *model, *sensor;
  std::size_t packets;
  int rings;
};

/// The first data packets of a pcap of a Velodyne sensor, as one observation.
inline mrpt::obs::CObservationVelodyneScan::Ptr velodyneScan(const std::string& pcap,
                                                             const std::string& model,
                                                             std::size_t packets) {
  using Scan = mrpt::obs::CObservationVelodyneScan;
  constexpr std::size_t kFileHeader = 24, kPacketHeader = 16, kUdpHeader = 42;
  auto scan = Scan::Create();
  scan->calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model);
  scan->timestamp = toMrptTime(1000.0);
  scan->sensorLabel = "velodyne";
  for (std::size_t at = kFileHeader;
       at + kPacketHeader < pcap.size() && scan->scan_packets.size() < packets;) {
    std::uint32_t length = 0;
    std::memcpy(&length, pcap.data() + at + 8, sizeof length);
    if (length == kUdpHeader + Scan::PACKET_SIZE) {
      Scan::TVelodyneRawPacket packet;
      std::memcpy(static_cast<void*>(&packet), pcap.data() + at + kPacketHeader + kUdpHeader,
                  Scan::PACKET_SIZE);
      scan->scan_packets.push_back(packet);
    }
    at += kPacketHeader + length;
  }
  return scan;
}

inline mrpt::obs::CObservationVelodyneScan::Ptr velodyneScan(const VelodyneCase& real) {
  return velodyneScan(readBytes(dataFolder() / "velodyne" / real.file), real.model, real.packets);
}

}  // namespace toss::test
