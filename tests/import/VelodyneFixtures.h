// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CRawlog.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "CaptureFixtures.h"

/// Packets of Velodyne sensors for tests, and what MRPT itself finds in a rawlog.
namespace toss::test {

/// A data packet as it lies in the datagram.
struct DataPacket {
  /// Azimuth of the first block, and from one block (HDL-64E: pair of blocks) to the next [0.01
  /// degrees].
  int rotation = 0, step = 40;
  /// Sensor's clock [us].
  std::uint32_t microseconds = 0;
  std::uint8_t mode = 0x37, factoryByte = 0x22;
  bool lowerBank = false;
  /// Range of all returns [2 mm].
  int distance = 2500;
};

inline std::string bytesOf(const DataPacket& packet) {
  std::string bytes;
  const int perAzimuth = packet.lowerBank || packet.mode == 0x39 ? 2 : 1;
  for (int block = 0; block < 12; ++block) {
    const bool lower = packet.lowerBank && block % 2 == 1;
    bytes += littleBytes(lower ? 0xddff : 0xeeff, 2);
    const int rotation = packet.rotation + block / perAzimuth * packet.step;
    bytes += littleBytes(static_cast<std::uint64_t>(rotation % 36000), 2);
    for (int laser = 0; laser < 32; ++laser)
      bytes += littleBytes(static_cast<std::uint64_t>(packet.distance + laser), 2) + '\x20';
  }
  bytes += littleBytes(packet.microseconds, 4) + static_cast<char>(packet.mode);
  return bytes + static_cast<char>(packet.factoryByte);
}

inline std::string frameOf(const DataPacket& packet, std::uint16_t port = 2368) {
  return ethernetOf(ipv4Of(udpOf(bytesOf(packet), port)));
}

/// A position packet with that sentence, its checksum put behind it.
inline std::string positionFrame(std::uint32_t microseconds, const std::string& sentence) {
  unsigned sum = 0;
  for (const char c : sentence) sum ^= static_cast<unsigned char>(c);
  char checksum[8];
  std::snprintf(checksum, sizeof checksum, "*%02X\r\n", sum);
  std::string bytes(512, '\0');
  bytes.replace(198, 4, littleBytes(microseconds, 4));
  const std::string text = "$" + sentence + checksum;
  bytes.replace(206, text.size(), text);
  return ethernetOf(ipv4Of(udpOf(bytes, 8308)));
}

/// Frames of `count` packets of a VLP-16 that turns 4.8 degrees per packet.
inline std::vector<std::string> turningFrames(int count, DataPacket packet = {}) {
  std::vector<std::string> frames;
  for (int i = 0; i < count; ++i) {
    frames.push_back(frameOf(packet));
    packet.rotation = (packet.rotation + 12 * packet.step) % 36000;
    packet.microseconds = (packet.microseconds + 1327) % 3'600'000'000u;
  }
  return frames;
}

/// The observations of one class in a rawlog, as MRPT reads them.
template <typename Observation>
std::vector<typename Observation::Ptr> observationsIn(const std::filesystem::path& file) {
  mrpt::obs::CRawlog rawlog;
  rawlog.loadFromRawLogFile(file.string());
  std::vector<typename Observation::Ptr> result;
  for (std::size_t i = 0; i < rawlog.size(); ++i)
    if (auto found = std::dynamic_pointer_cast<Observation>(rawlog.getAsGeneric(i)))
      result.push_back(found);
  return result;
}

}  // namespace toss::test
