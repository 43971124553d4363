// SPDX-License-Identifier: BSD-3-Clause
#include "VelodyneHalves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace toss {
namespace {

using mrpt::obs::CObservationVelodyneScan;
using RawPacket = CObservationVelodyneScan::TVelodyneRawPacket;
using Bytes = std::array<std::uint8_t, sizeof(RawPacket)>;

constexpr std::size_t kBlocks = 12, kBlockBytes = 100, kBlockHead = 4, kHalfBytes = 48;
constexpr int kFullTurn = 36000;

/// Share of a block's turn after which its second half begins to fire: a VLP-16 fires all lasers
/// again after half of it, an HDL-32E has its laser 16 fire 16 of 40 steps later (user manuals); an
/// HDL-64E fires both halves at once, as far as MRPT is concerned.
double secondHalfDelay(std::size_t lasers) {
  return lasers == 16 ? 0.5 : lasers == 32 ? 16.0 * 1.152 / 46.08 : 0.0;
}

/// Turn from one firing to the next [0.01 degrees]: the packet's median, as MRPT takes it.
int medianTurn(const RawPacket& packet) {
  const bool dual = packet.laser_return_mode == CObservationVelodyneScan::RETMODE_DUAL;
  const std::size_t next = dual ? 2 : 1, count = kBlocks - next;
  std::array<int, kBlocks> turns{};
  for (std::size_t i = 0; i < count; ++i)
    turns[i] =
        (kFullTurn + packet.blocks[i + next].rotation() - packet.blocks[i].rotation()) % kFullTurn;
  const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(turns.begin(), middle, turns.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

void moveHalves(RawPacket& packet, double delay) {
  const int turn = static_cast<int>(std::lround(delay * medianTurn(packet)));
  Bytes bytes;
  std::memcpy(bytes.data(), &packet, bytes.size());
  for (std::size_t block = 0; block < kBlocks; ++block) {
    std::uint8_t* at = bytes.data() + block * kBlockBytes;
    const int azimuth = (packet.blocks[block].rotation() + turn) % kFullTurn;
    at[2] = static_cast<std::uint8_t>(azimuth & 0xFF);
    at[3] = static_cast<std::uint8_t>(azimuth >> 8);
    std::memcpy(at + kBlockHead, at + kBlockHead + kHalfBytes, kHalfBytes);
  }
  std::memcpy(static_cast<void*>(&packet), bytes.data(), bytes.size());
}

struct Counter : CObservationVelodyneScan::PointCloudStorageWrapper {
  void add_point(float, float, float, std::uint8_t, const mrpt::system::TTimeStamp&, float,
                 std::uint16_t) override {
    ++points;
  }
  std::size_t points = 0;
};

}  // namespace

bool mrptLosesSecondHalves() {
  static const bool loses = [] {
    Bytes bytes{};
    for (std::size_t block = 0; block < kBlocks; ++block) {
      std::uint8_t* at = bytes.data() + block * kBlockBytes;
      at[0] = 0xff, at[1] = 0xee;
      // Ranges of about 20 m in the second half only.
      for (std::size_t i = 0; i < 16; ++i) at[kBlockHead + kHalfBytes + 3 * i + 1] = 40;
    }
    CObservationVelodyneScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.0);
    scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("HDL32");
    scan.scan_packets.resize(1);
    std::memcpy(static_cast<void*>(scan.scan_packets.data()), bytes.data(), bytes.size());
    Counter counter;
    scan.generatePointCloud(counter);
    return counter.points == 0;
  }();
  return loses;
}

CObservationVelodyneScan secondHalves(const CObservationVelodyneScan& scan) {
  CObservationVelodyneScan result = scan;
  auto& lasers = result.calibration.laser_corrections;
  const double delay = secondHalfDelay(lasers.size());
  for (RawPacket& packet : result.scan_packets) moveHalves(packet, delay);
  for (std::size_t bank = 0; bank + 32 <= lasers.size(); bank += 32)
    std::copy_n(lasers.begin() + static_cast<std::ptrdiff_t>(bank + 16), 16,
                lasers.begin() + static_cast<std::ptrdiff_t>(bank));
  return result;
}

}  // namespace toss
