// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VoxelRecord.h"

namespace toss {

/// The voxels of one brick of 4 x 4 x 4 blocks that hold returns, by ascending key, in one run of
/// memory: a scan that touches one of them touches its neighbours too.
class VoxelBrick {
 public:
  /// Contributions in a row that go to voxels of this brick, by ascending key.
  struct Group {
    const VoxelContribution *begin, *end;
  };

  /// Adds the groups [first, last); returns how many voxels were not there before.
  std::uint32_t add(const Group* first, const Group* last);
  /// Takes one sum back; returns how many voxels are empty and gone by it. std::logic_error where
  /// it was never added.
  std::uint32_t subtract(const VoxelSum& sum);

  /// Appends the voxels to `bytes`; restore() of an empty brick takes them from there and returns
  /// where they end.
  void save(std::vector<std::uint8_t>& bytes) const;
  const std::uint8_t* restore(const std::uint8_t* bytes);

  bool empty() const { return blockMask_ == 0; }
  std::uint32_t size() const { return size_; }
  /// Calls `visit(const VoxelSum&)` for each voxel by ascending key. `brickKey`: upper bits of the
  /// keys, without the lower ones.
  template <typename Visit>
  void visit(VoxelKey brickKey, Visit&& visit) const {
    const VoxelRecord* record = records_.get();
    const Block* block = blocks_.get();
    for (std::uint64_t blocks = blockMask_; blocks != 0; blocks &= blocks - 1, ++block) {
      const VoxelKey blockKey =
          brickKey << kBrickShift | static_cast<VoxelKey>(__builtin_ctzll(blocks)) << kBlockShift;
      for (std::uint64_t left = block->mask; left != 0; left &= left - 1)
        visit((record++)->sum(blockKey | static_cast<VoxelKey>(__builtin_ctzll(left))));
    }
  }
  /// Calls what add() needs into the cache: first what tells the places, then what lies there.
  void prefetchBlocks() const { __builtin_prefetch(blocks_.get()); }
  void prefetchRecords(const Group& group) const;
  /// Bytes held beside this object, room for growth included.
  std::size_t bytes() const;

 private:
  /// Voxels of a block that hold returns, and the place of the first of them.
  struct Block {
    std::uint64_t mask = 0;
    std::uint32_t first = 0;
  };

  /// The block of a key, nullptr where it holds nothing.
  Block* find(VoxelKey key) const {
    const std::uint64_t bit = std::uint64_t{1} << (key >> kBlockShift & 63);
    return (blockMask_ & bit) == 0 ? nullptr : &blocks_[countBits(blockMask_ & (bit - 1))];
  }
  /// Bits of a word that are set. Processors without an instruction for it are to run the program
  /// too, and a call for each voxel takes longer than this.
  static std::uint32_t countBits(std::uint64_t v) {
    v -= v >> 1 & 0x5555555555555555u;
    v = (v & 0x3333333333333333u) + (v >> 2 & 0x3333333333333333u);
    v = (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<std::uint32_t>(v * 0x0101010101010101u >> 56);
  }
  /// Makes empty records for voxels; `added`: by block, those that have none.
  void make(const std::uint64_t* added, std::uint64_t addedBlocks);
  void moveRecords(const Block* blocks, int count, const std::uint64_t* addedOf,
                   std::uint32_t newSize);
  void addToRecords(const Group& group);
  void erase(VoxelKey key, Block& block);
  void reserve(std::uint32_t size);

  std::uint64_t blockMask_ = 0;
  std::unique_ptr<Block[]> blocks_;
  std::unique_ptr<VoxelRecord[]> records_;
  std::uint32_t size_ = 0, capacity_ = 0;
};

}  // namespace toss
