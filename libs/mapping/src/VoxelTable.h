// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include "VoxelBrick.h"

namespace toss {

/// Voxels of a map: bricks in an open-addressing table, of which a scan touches few.
class VoxelTable {
 public:
  /// Groups [first, last) of contributions that go to one brick of a table.
  struct Addition {
    VoxelTable* table;
    const VoxelBrick::Group *first, *last;
    /// Set by add(): the brick, nullptr where it is new.
    VoxelBrick* brick;
  };
  /// Adds [first, last), few enough for the first-level cache: the memory answers the questions
  /// for all of them at a time. Returns how many voxels were not there before.
  static std::size_t add(Addition* first, Addition* last);
  /// Takes one sum back; std::logic_error where it was never added.
  void subtract(const VoxelSum& sum);

  /// Voxels that hold returns.
  std::size_t size() const { return size_; }
  /// Calls `visit(const VoxelSum&)` for each voxel by ascending key.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const VoxelKey key : sortedBricks()) bricks_.find(key)->second.visit(key, visit);
  }
  std::size_t bytes() const;

  /// Replaces `bytes` by everything held here, for restore() of an empty table in the same program.
  void save(std::vector<std::uint8_t>& bytes) const;
  void restore(const std::vector<std::uint8_t>& bytes);

 private:
  struct Hash {
    std::size_t operator()(VoxelKey brickKey) const;
  };
  std::uint32_t add(const Addition& addition, VoxelBrick& brick);
  std::vector<VoxelKey> sortedBricks() const;

  tsl::robin_map<VoxelKey, VoxelBrick, Hash> bricks_;
  std::size_t size_ = 0;
};

}  // namespace toss
