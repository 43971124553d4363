// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace toss {

/// Index of a voxel: floor(p / voxelSize) per axis, 3 x 21 bits (spec section 8.2). Keys ascend
/// with the index along x, then y, then z.
using VoxelKey = std::uint64_t;

/// Bits per axis, and the index of the first voxel out of reach: keys hold -2^20 .. 2^20 - 1.
constexpr int kVoxelKeyBits = 21;
constexpr std::int32_t kVoxelReach = 1 << (kVoxelKeyBits - 1);

/// The key of a voxel from its index, each in [-kVoxelReach, kVoxelReach).
constexpr VoxelKey voxelKey(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto shifted = [](std::int32_t i) { return static_cast<VoxelKey>(i + kVoxelReach); };
  return shifted(x) << (2 * kVoxelKeyBits) | shifted(y) << kVoxelKeyBits | shifted(z);
}

/// The index of a voxel from its key: x, y, z.
constexpr std::array<std::int32_t, 3> voxelIndex(VoxelKey key) {
  constexpr VoxelKey mask = (VoxelKey{1} << kVoxelKeyBits) - 1;
  const auto index = [](VoxelKey bits) { return static_cast<std::int32_t>(bits) - kVoxelReach; };
  return {index(key >> (2 * kVoxelKeyBits) & mask), index(key >> kVoxelKeyBits & mask),
          index(key & mask)};
}

}  // namespace toss
