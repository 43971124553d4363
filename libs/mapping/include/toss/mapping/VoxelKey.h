// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace toss {

/// Index of a voxel: floor(p / voxelSize) per axis, counted from the first voxel, 3 x 21 bits: x
/// above y above z (spec section 8.2).
using VoxelKey = std::uint64_t;

/// Bits per axis, and the index of the first voxel out of reach: keys hold -2^20 .. 2^20 - 1.
constexpr int kVoxelKeyBits = 21;
constexpr std::int32_t kVoxelReach = 1 << (kVoxelKeyBits - 1);
/// Bits per axis of the voxel in its block of 4 x 4 x 4, and of the voxel in its brick of 4 x 4 x 4
/// blocks.
constexpr int kBlockBits = 2, kBrickBits = 4;
/// Voxels along the edge of a brick.
constexpr int kBrickVoxels = 1 << kBrickBits;

/// The key of a voxel from its index counted from the first voxel, each in [0, 2 kVoxelReach).
constexpr VoxelKey voxelKeyFromFirst(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x << 2 * kVoxelKeyBits | y << kVoxelKeyBits | z;
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
    const std::uint64_t fromFirst =
        key >> kVoxelKeyBits * (2 - axis) & ((std::uint64_t{1} << kVoxelKeyBits) - 1);
    index[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(fromFirst) - kVoxelReach;
  }
  return index;
}

/// The key of the first voxel of the cube of 2^bits voxels a side in which a voxel lies.
constexpr VoxelKey cubeOf(VoxelKey key, int bits) {
  const std::uint64_t inCube = (std::uint64_t{1} << bits) - 1;
  return key & ~voxelKeyFromFirst(inCube, inCube, inCube);
}

/// The place of a voxel in its block, 0 .. 63, x before y before z; and the voxel at a place of the
/// block whose first voxel is `block`. The product moves the two bits of each axis to the top ones,
/// and what else it gives is cut off on either side.
constexpr std::uint64_t placeInBlock(VoxelKey key) {
  constexpr std::uint64_t kOne = 1, kToTop = kOne << 58 | kOne << (60 - kVoxelKeyBits) |
                                             kOne << (62 - 2 * kVoxelKeyBits);
  return (key & voxelKeyFromFirst(3, 3, 3)) * kToTop >> 58;
}
constexpr VoxelKey voxelInBlock(VoxelKey block, std::uint64_t place) {
  return block | voxelKeyFromFirst(place >> 4, place >> 2 & 3, place & 3);
}

/// Moves bit i to bit 3 i, for the lower 17 bits.
constexpr std::uint64_t spreadBits(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffu;
  v = (v | v << 16) & 0x1f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  return (v | v << 2) & 0x1249249249249249u;
}

/// Where a block stands among those of a finished map, from its first voxel: bricks are in Morton
/// order, so that every cube of 2^k bricks a side, counted from the first, is one run of places;
/// and the blocks of a brick follow each other with x before y before z.
constexpr std::uint64_t placeInMap(VoxelKey block) {
  constexpr std::uint64_t kAxis = (std::uint64_t{1} << kVoxelKeyBits) - 1;
  const std::uint64_t x = block >> 2 * kVoxelKeyBits, y = block >> kVoxelKeyBits & kAxis,
                      z = block & kAxis;
  const std::uint64_t brick = spreadBits(x >> kBrickBits) << 2 | spreadBits(y >> kBrickBits) << 1 |
                              spreadBits(z >> kBrickBits);
  return brick << 6 | (x >> kBlockBits & 3) << 4 | (y >> kBlockBits & 3) << 2 |
         (z >> kBlockBits & 3);
}

}  // namespace toss
