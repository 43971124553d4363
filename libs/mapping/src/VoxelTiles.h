// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/TileStore.h>

#include <array>
#include <map>

#include "VoxelTable.h"

namespace toss {

/// The voxels of a map in cubes, of which those that are far away can be put into a store. What the
/// map holds does not depend on it.
class VoxelTiles {
 public:
  /// `tileVoxels`: least edge of a tile in voxels, made larger to be 2^k bricks; 0 = one tile.
  /// `store`: outlives this object; nullptr = everything stays in memory.
  VoxelTiles(double tileVoxels, TileStore* store);

  /// Adds contributions of several spans together: brick after brick.
  void add(const ContributionSpan* first, const ContributionSpan* last);
  /// Takes one sum back; std::logic_error where it was never added.
  void subtract(const VoxelSum& sum);
  /// Puts tiles into the store that are farther than `radius` from `place` (both in voxels, counted
  /// from the first voxel) and were not needed in the last calls.
  void leaveBehind(const std::array<double, 3>& place, double radius);

  std::size_t size() const { return size_; }
  /// Calls `visit(const VoxelSum&)` for each voxel by ascending key. Tiles of the store are loaded
  /// one after another and dropped again.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const auto& [key, tile] : tiles_) {
      if (tile.table)
        tile.table->visit(visit);
      else
        loaded(key)->visit(visit);
    }
  }
  /// Bytes held in memory.
  std::size_t bytes() const;
  /// Tiles in memory, and in the store.
  std::size_t tilesInMemory() const;
  std::size_t tilesInStore() const { return tiles_.size() - tilesInMemory(); }

 private:
  struct Tile {
    /// nullptr = in the store.
    std::unique_ptr<VoxelTable> table;
    /// Call of leaveBehind() before which it was needed last.
    std::uint64_t needed = 0;
  };
  /// Bricks that are looked up together, so that the memory answers many questions at a time.
  static constexpr std::size_t kBatch = 32;
  Tile& tileOf(VoxelKey key);
  /// Fills groups_: the contributions that go to one brick each, by ascending brick.
  void groupByBrick(const ContributionSpan* first, const ContributionSpan* last);
  std::unique_ptr<VoxelTable> loaded(std::uint64_t tile) const;
  bool isFar(std::uint64_t tile, const std::array<double, 3>& place, double radius) const;

  /// Bits of a key below those that name the tile.
  int shift_ = 63;
  TileStore* store_;
  /// By the upper bits of their keys: order of tiles is order of keys.
  std::map<std::uint64_t, Tile> tiles_;
  std::size_t size_ = 0;
  std::uint64_t calls_ = 0;
  std::vector<std::uint8_t> bytes_;
  std::vector<VoxelBrick::Group> groups_;
};

}  // namespace toss
