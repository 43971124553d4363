// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Times of the firings of a scan. MRPT gives all points of a packet, which takes up to 1.3 ms, the
/// time of its first firing; where a firing lies in it is told by its azimuth.
class VelodyneTimes {
 public:
  explicit VelodyneTimes(const mrpt::obs::CObservationVelodyneScan& scan);

  /// Time of a return since the scan's time stamp [s]. `packetTime`: that of its packet since then
  /// as MRPT gives it [us], ascending from call to call, or from the first anew; `azimuth`:
  /// as MRPT gives it to a PointCloudStorageWrapper [0.01 degrees].
  float timeOf(std::int64_t packetTime, float azimuth);

 private:
  struct Packet {
    /// Since the first packet, as MRPT counts [us]; of the first firing [0.01 degrees].
    std::int64_t time = 0;
    float azimuth = 0.0f;
  };
  std::vector<Packet> packets_;
  std::size_t current_ = 0;
  /// Median over the scan: of a packet's duration [us] and turn [0.01 degrees].
  float duration_ = 0.0f, turn_ = 0.0f;
};

}  // namespace toss
