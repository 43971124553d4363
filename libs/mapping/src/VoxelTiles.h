// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/TileStore.h>

#include <array>
#include <map>

#include "VoxelBlocks.h"

namespace toss {

/// The voxels of a map in cubes, of which those that are far away can be put into a store. What the
/// map holds does not depend on it.
class VoxelTiles {
 public:
  /// `tileVoxels`: least edge of a tile in voxels, made larger to be 2^k bricks; 0 = one tile.
  /// `store`: outlives this object; nullptr = everything stays in memory.
  VoxelTiles(double tileVoxels, TileStore* store);

  /// Adds runs, but those of the owners that `without` marks where it is given.
  void add(const RunSpan& runs, const std::vector<bool>* without);
  /// Takes runs, or one sum, back; std::logic_error where they were never added.
  void subtract(const RunSpan& runs);
  void subtract(const VoxelSum& sum);
  /// Whether any voxel holds returns of the cube of 2^bits voxels a side in which `voxel` lies;
  /// `bits` is at most kBlockBits.
  bool holds(VoxelKey voxel, int bits);
  /// Puts tiles into the store that are farther than `radius` from `place` (both in voxels, counted
  /// from the first voxel) and were not needed in the last calls.
  void leaveBehind(const std::array<double, 3>& place, double radius);

  std::size_t size() const;
  /// Calls `visit(const VoxelSum&)` for each voxel in order of the map. Tiles of the store are
  /// loaded one after another and dropped again.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const auto& [place, tile] : tiles_) {
      if (tile.blocks)
        tile.blocks->visit(visit);
      else
        loaded(place)->visit(visit);
    }
  }
  /// Bytes held in memory.
  std::size_t bytes() const;
  /// Tiles in memory, and in the store.
  std::size_t tilesInMemory() const;
  std::size_t tilesInStore() const { return tiles_.size() - tilesInMemory(); }

 private:
  struct Tile {
    /// Its first voxel.
    VoxelKey key = 0;
    /// nullptr = in the store.
    std::unique_ptr<VoxelBlocks> blocks;
    /// Voxels of it while it is there.
    std::size_t sizeInStore = 0;
    /// Call of leaveBehind() before which it was needed last.
    std::uint64_t needed = 0;
  };
  void addAll(const RunSpan& runs);
  VoxelBlocks& blocksOf(VoxelKey firstOfTile);
  /// Where a tile stands in the map; order of tiles is order of voxels.
  std::uint64_t placeOf(VoxelKey tile) const { return placeInMap(tile) >> placeShift_; }
  std::unique_ptr<VoxelBlocks> loaded(std::uint64_t tile) const;
  bool isFar(VoxelKey tile, const std::array<double, 3>& place, double radius) const;

  /// Bits per axis of the voxel in its tile; bits of a block's place in the map below the tile's.
  int tileBits_ = kVoxelKeyBits, placeShift_ = 63;
  TileStore* store_;
  /// By placeOf().
  std::map<std::uint64_t, Tile> tiles_;
  std::uint64_t calls_ = 0;
  /// Bytes of tiles put into the store since their memory went back to the system.
  std::size_t givenUp_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace toss
