// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "VoxelReturns.h"

namespace toss {

/// Returns of a scan, few enough for the first-level cache, in whole numbers.
struct FixedChunk {
  static constexpr std::size_t kMost = 256;
  /// The key of returns that go nowhere.
  static constexpr VoxelKey kNoVoxel = ~VoxelKey{0};
  using Words = std::array<std::uint64_t, kMost>;

  std::size_t count = 0;
  /// Voxel of each return, kNoVoxel where its owner is below 0 or it is not finite or out of reach.
  Words key;
  /// Words of a VoxelRun of that return alone, the second of them in its two parts.
  Words countAndOffsets, owner, intensity;
  /// Not 0 where a return has another voxel or owner than the one before it.
  Words change;
  /// Returns of owners from 0 on that are not finite or out of reach.
  std::size_t leftOut = 0;

  /// Replaces all by the returns at places [begin, begin + kMost) as far as there are.
  void fill(const VoxelReturns& returns, std::size_t begin);

 private:
  void dropOutOfReach();

  /// Fixed-point coordinates, counted from the first voxel.
  Words x_, y_, z_;
};

}  // namespace toss
