// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

namespace toss {

/// The sums of one voxel in 32 bytes, none of which two lines of the cache share: those of the
/// offsets have 48 bits, enough for 2^32 returns, and above them stand the halves of the count.
class alignas(32) VoxelRecord {
 public:
  VoxelSum sum(VoxelKey key) const {
    return {key, count(), xAndCountLow_ & kOffset, yAndCountHigh_ & kOffset, z_, intensity_};
  }
  std::uint32_t count() const {
    return static_cast<std::uint32_t>(yAndCountHigh_ >> kBits << 16 | xAndCountLow_ >> kBits);
  }
  void add(const VoxelRun& run) {
    std::uint64_t counted = 0;
    const bool carry =
        __builtin_add_overflow(xAndCountLow_, run.count() << kBits | run.x(), &counted);
    xAndCountLow_ = counted;
    yAndCountHigh_ += static_cast<std::uint64_t>(carry) << kBits | run.y();
    z_ += run.z();
    intensity_ += run.intensity();
  }
  void set(const VoxelSum& sum) {
    const std::uint64_t count = sum.count;
    xAndCountLow_ = count << kBits | sum.x;
    yAndCountHigh_ = count >> 16 << kBits | sum.y;
    z_ = sum.z;
    intensity_ = sum.intensity;
  }

 private:
  static constexpr int kBits = 48;
  static constexpr std::uint64_t kOffset = (std::uint64_t{1} << kBits) - 1;

  std::uint64_t xAndCountLow_ = 0, yAndCountHigh_ = 0, z_ = 0, intensity_ = 0;
};
static_assert(sizeof(VoxelRecord) == 32, "the map's memory is counted in these");

}  // namespace toss
