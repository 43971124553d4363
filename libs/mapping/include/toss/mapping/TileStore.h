// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace toss {

/// Keeps the tiles of a map that the robot has left behind, outside of memory.
class TileStore {
 public:
  virtual ~TileStore() = default;

  /// Keeps the bytes of a tile, in place of what was kept of it before. Throws UserError where
  /// there is no room.
  virtual void store(std::uint64_t tile, const std::vector<std::uint8_t>& bytes) = 0;
  /// Replaces `bytes` by what was stored last of a tile, which was stored. Throws UserError where
  /// it can not be read.
  virtual void load(std::uint64_t tile, std::vector<std::uint8_t>& bytes) = 0;
};

}  // namespace toss
