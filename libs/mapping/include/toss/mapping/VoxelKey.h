// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toss {

/// Index of a voxel: floor(p / voxelSize) per axis, 3 x 21 bits (spec section 8.2). The lower 6
/// bits name the voxel in its block of 4 x 4 x 4, the next 6 the block in its brick of 4 x 4 x 4
/// blocks, each with x before y before z. The upper 51 name the brick with the bits of its three
/// axes interleaved (Morton order), so that every cube of 2^k bricks a side, counted from the
/// first, is one run of keys.
using VoxelKey = std::uint64_t;

/// Bits per axis, and the index of the first voxel out of reach: keys hold -2^20 .. 2^20 - 1.
constexpr int kVoxelKeyBits = 21;
constexpr std::int32_t kVoxelReach = 1 << (kVoxelKeyBits - 1);
/// Bits per axis of the voxel in its block and of the block in its brick.
constexpr int kVoxelLocalBits = 2;
/// Bits of a key below those of the block and of the brick.
constexpr int kBlockShift = 3 * kVoxelLocalBits, kBrickShift = 6 * kVoxelLocalBits;
/// Voxels along the edge of a brick.
constexpr int kBrickVoxels = 1 << 2 * kVoxelLocalBits;

namespace detail {

/// Moves bit i to bit 3 i, for the lower 17 bits.
constexpr std::uint64_t spreadBits(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffu;
  v = (v | v << 16) & 0x1f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  return (v | v << 2) & 0x1249249249249249u;
}

/// The inverse of spreadBits; the bits between do not matter.
constexpr std::uint64_t gatherBits(std::uint64_t v) {
  v &= 0x1249249249249249u;
  v = (v | v >> 2) & 0x10c30c30c30c30c3u;
  v = (v | v >> 4) & 0x100f00f00f00f00fu;
  v = (v | v >> 8) & 0x1f0000ff0000ffu;
  v = (v | v >> 16) & 0x1f00000000ffffu;
  return (v | v >> 32) & 0x1fffffu;
}

}  // namespace detail

/// The upper bits of a key, from the index of the brick counted from the first brick.
constexpr VoxelKey brickKeyFromFirst(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return (detail::spreadBits(x) << 2 | detail::spreadBits(y) << 1 | detail::spreadBits(z))
         << kBrickShift;
}

/// The lower bits of a key: voxel in block and block in brick, from an index in any frame that
/// begins with a brick.
constexpr VoxelKey localKey(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  const auto level = [&](int bits) {
    return (x >> bits & 3) << 4 | (y >> bits & 3) << 2 | (z >> bits & 3);
  };
  return level(kVoxelLocalBits) << kBlockShift | level(0);
}

/// The key of a voxel from its index counted from the first voxel, each in [0, 2 kVoxelReach).
constexpr VoxelKey voxelKeyFromFirst(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  constexpr int shift = 2 * kVoxelLocalBits;
  return brickKeyFromFirst(x >> shift, y >> shift, z >> shift) | localKey(x, y, z);
}

/// The key of a voxel from its index, each in [-kVoxelReach, kVoxelReach).
constexpr VoxelKey voxelKey(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto fromFirst = [](std::int32_t i) { return static_cast<std::uint64_t>(i + kVoxelReach); };
  return voxelKeyFromFirst(fromFirst(x), fromFirst(y), fromFirst(z));
}

/// The index of a voxel from its key: x, y, z.
constexpr std::array<std::int32_t, 3> voxelIndex(VoxelKey key) {
  std::array<std::int32_t, 3> index{};
  for (int axis = 0; axis < 3; ++axis) {
    const int local = kVoxelLocalBits * (2 - axis);
    const std::uint64_t brick = detail::gatherBits(key >> (kBrickShift + 2 - axis));
    const std::uint64_t block = key >> (kBlockShift + local) & 3, voxel = key >> local & 3;
    const auto fromFirst = static_cast<std::int32_t>(brick << 4 | block << 2 | voxel);
    index[static_cast<std::size_t>(axis)] = fromFirst - kVoxelReach;
  }
  return index;
}

}  // namespace toss
