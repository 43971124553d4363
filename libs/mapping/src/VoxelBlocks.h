// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>

#include "LargeSums.h"
#include "RecordPool.h"

namespace toss {

/// Voxels of a tile in blocks of 4 x 4 x 4: an open-addressing table of the blocks that hold
/// returns, each with the records of its voxels by place in an array of their own. Runs are added
/// in any order.
class VoxelBlocks {
 public:
  struct Block {
    /// Its first voxel, kNone where the slot is free.
    VoxelKey key = kNone;
    /// Voxels that hold returns.
    std::uint64_t mask = 0;
    VoxelRecord* records = nullptr;
  };
  /// Runs that are added together.
  static constexpr std::size_t kBatch = 64;

  /// Calls what add() and subtract() ask first of a block into the cache; there are blocks. `hash`:
  /// of its key.
  void prefetch(std::uint64_t hash) const {
    const Block* const slot = &slots_[hash >> hashShift_];
    __builtin_prefetch(slot);
    // It may lie across two lines of the cache.
    __builtin_prefetch(&slot->records);
  }
  static std::uint64_t hash(VoxelKey block) {
    const std::uint64_t mixed = (block ^ block >> 32) * 0x9e3779b97f4a7c15u;
    return (mixed ^ mixed >> 32) * 0x9e3779b97f4a7c15u;
  }
  /// Adds [first, last), at most kBatch.
  void add(const VoxelRun* first, const VoxelRun* last);
  /// Takes one sum back; std::logic_error where it was never added.
  void subtract(const VoxelSum& sum);

  /// Whether any voxel holds returns of the cube of 2^bits voxels a side in which `voxel` lies; a
  /// cube is no larger than a block.
  bool holds(VoxelKey voxel, int bits) const;
  /// Voxels that hold returns.
  std::size_t size() const { return size_; }
  /// Calls `visit(const VoxelSum&)` for each voxel in order of the map.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const Block* block : sortedBlocks()) {
      const VoxelRecord* record = block->records;
      for (std::uint64_t left = block->mask; left != 0; left &= left - 1)
        visit(sumOf(*record++, voxelInBlock(block->key, lowestPlace(left))));
    }
  }
  std::size_t bytes() const {
    return slots_.size() * sizeof(Block) + pool_.bytes() + large_.bytes();
  }

  /// Replaces `bytes` by everything held here, for restore() of an empty object in the same
  /// program.
  void save(std::vector<std::uint8_t>& bytes) const;
  void restore(const std::vector<std::uint8_t>& bytes);

 private:
  static constexpr VoxelKey kNone = ~VoxelKey{0};

  struct Batch;

  static std::uint64_t bitOf(VoxelKey key) { return std::uint64_t{1} << placeInBlock(key); }
  static std::uint32_t countBits(std::uint64_t v) {
    return static_cast<std::uint32_t>(__builtin_popcountll(v));
  }
  static std::uint64_t lowestPlace(std::uint64_t voxels) {
    return static_cast<std::uint64_t>(__builtin_ctzll(voxels));
  }

  /// Number of the slot of a block, or of the free one that it would take.
  std::size_t findSlot(VoxelKey block, std::uint64_t hashOfBlock) const {
    std::size_t slot = hashOfBlock >> hashShift_;
    while (slots_[slot].key != block && slots_[slot].key != kNone) slot = (slot + 1) & lastSlot_;
    return slot;
  }
  Block& slotOf(VoxelKey block, std::uint64_t hashOfBlock) {
    return slots_[findSlot(block, hashOfBlock)];
  }
  Block& findOrMake(VoxelKey block, std::uint64_t hashOfBlock) {
    Block& slot = slotOf(block, hashOfBlock);
    if (slot.key == block) return slot;
    ++used_;
    slot.key = block;
    return slot;
  }
  std::vector<const Block*> sortedBlocks() const;
  VoxelSum sumOf(const VoxelRecord& record, VoxelKey key) const {
    if (!record.isReference()) return record.sum(key);
    VoxelSum sum = large_[record.place()];
    sum.key = key;
    return sum;
  }
  /// The steps of add().
  void findStretches(Batch& batch) const;
  void findBlocks(Batch& batch);
  void makeRecords(Batch& batch);
  /// Makes room for the blocks of a batch: it comes without the others moving.
  void makeRoom() {
    if ((used_ + kBatch) * 3 > slots_.size() * 2) grow(used_ + kBatch);
  }
  /// Adds a run that a record can not count itself.
  void addLarge(VoxelRecord& record, const VoxelRun& run);
  /// Replaces the sums of a record by what is left of them.
  void setLess(VoxelRecord& record, const VoxelSum& left);
  /// Makes empty records of voxels that have none.
  void insert(Block& block, std::uint64_t voxels);
  void erase(Block& block, std::uint64_t voxel);
  void eraseBlock(Block& block);
  void grow(std::size_t blocks);

  std::vector<Block> slots_;
  /// Bits of a hash below those that name a slot.
  int hashShift_ = 64;
  std::size_t lastSlot_ = 0, used_ = 0, size_ = 0;
  RecordPool pool_;
  LargeSums large_;
};

}  // namespace toss
