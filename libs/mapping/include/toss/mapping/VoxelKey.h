// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toss {

/// Index of a voxel: floor(p / voxelSize) per axis, 3 x 21 bits (spec section 8.2). The upper 57
/// bits name the block of 4 x 4 x 4 voxels and the lower 6 the voxel in it, each with x before y
/// before z: voxels that are near each other have keys that are near each other.
using VoxelKey = std::uint64_t;

/// Bits per axis, and the index of the first voxel out of reach: keys hold -2^20 .. 2^20 - 1.
constexpr int kVoxelKeyBits = 21;
constexpr std::int32_t kVoxelReach = 1 << (kVoxelKeyBits - 1);
/// Bits per axis of the voxel in its block, and of the block.
constexpr int kVoxelLocalBits = 2, kVoxelBlockBits = kVoxelKeyBits - kVoxelLocalBits;

/// The key of a voxel from its index counted from the first voxel, each in [0, 2 kVoxelReach).
constexpr VoxelKey voxelKeyFromFirst(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  constexpr std::uint32_t mask = (1u << kVoxelLocalBits) - 1;
  VoxelKey key = x >> kVoxelLocalBits;
  key = key << kVoxelBlockBits | y >> kVoxelLocalBits;
  key = key << kVoxelBlockBits | z >> kVoxelLocalBits;
  key = key << kVoxelLocalBits | (x & mask);
  key = key << kVoxelLocalBits | (y & mask);
  return key << kVoxelLocalBits | (z & mask);
}

/// The key of a voxel from its index, each in [-kVoxelReach, kVoxelReach).
constexpr VoxelKey voxelKey(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto fromFirst = [](std::int32_t i) { return static_cast<std::uint32_t>(i + kVoxelReach); };
  return voxelKeyFromFirst(fromFirst(x), fromFirst(y), fromFirst(z));
}

/// The index of a voxel from its key: x, y, z.
constexpr std::array<std::int32_t, 3> voxelIndex(VoxelKey key) {
  std::array<std::int32_t, 3> index{};
  for (int axis = 0; axis < 3; ++axis) {
    const int local = kVoxelLocalBits * (2 - axis);
    const int block = 3 * kVoxelLocalBits + kVoxelBlockBits * (2 - axis);
    const VoxelKey high = key >> block & ((1u << kVoxelBlockBits) - 1);
    const VoxelKey low = key >> local & ((1u << kVoxelLocalBits) - 1);
    const auto fromFirst = static_cast<std::int32_t>(high << kVoxelLocalBits | low);
    index[static_cast<std::size_t>(axis)] = fromFirst - kVoxelReach;
  }
  return index;
}

}  // namespace toss
