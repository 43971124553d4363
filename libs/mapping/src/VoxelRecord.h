// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// The sums of one voxel in 32 bytes: those of the offsets have 48 bits, enough for 2^32 returns.
struct VoxelRecord {
  std::uint32_t count = 0, intensityLow = 0, intensityHigh = 0;
  std::uint32_t xLow = 0, yLow = 0, zLow = 0;
  std::uint16_t xHigh = 0, yHigh = 0, zHigh = 0;

  VoxelSum sum(VoxelKey key) const {
    return {key,
            count,
            wide(xLow, xHigh),
            wide(yLow, yHigh),
            wide(zLow, zHigh),
            wide(intensityLow, intensityHigh)};
  }
  void add(const VoxelContribution& c) {
    set({c.key, count + c.count, wide(xLow, xHigh) + c.x, wide(yLow, yHigh) + c.y,
         wide(zLow, zHigh) + c.z, wide(intensityLow, intensityHigh) + c.intensity});
  }
  void set(const VoxelSum& sum) {
    count = sum.count;
    split(sum.x, xLow, xHigh);
    split(sum.y, yLow, yHigh);
    split(sum.z, zLow, zHigh);
    split(sum.intensity, intensityLow, intensityHigh);
  }

 private:
  static std::uint64_t wide(std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint64_t>(high) << 32 | low;
  }
  template <typename High>
  static void split(std::uint64_t value, std::uint32_t& low, High& high) {
    low = static_cast<std::uint32_t>(value);
    high = static_cast<High>(value >> 32);
  }
};
static_assert(sizeof(VoxelRecord) == 32, "the map's memory is counted in these");

}  // namespace toss
