// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <tsl/robin_map.h>

#include <array>

namespace toss {

/// The sums of one voxel in 32 bytes: those of the offsets have 48 bits, enough for 2^32 returns.
struct VoxelRecord {
  std::uint32_t count = 0, intensityLow = 0, intensityHigh = 0;
  std::uint32_t xLow = 0, yLow = 0, zLow = 0;
  std::uint16_t xHigh = 0, yHigh = 0, zHigh = 0;

  VoxelSum sum(VoxelKey key) const {
    return {key,
            count,
            wide(xLow, xHigh),
            wide(yLow, yHigh),
            wide(zLow, zHigh),
            wide(intensityLow, intensityHigh)};
  }
  void set(const VoxelSum& sum) {
    count = sum.count;
    split(sum.x, xLow, xHigh);
    split(sum.y, yLow, yHigh);
    split(sum.z, zLow, zHigh);
    split(sum.intensity, intensityLow, intensityHigh);
  }

 private:
  static std::uint64_t wide(std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint64_t>(high) << 32 | low;
  }
  template <typename High>
  static void split(std::uint64_t value, std::uint32_t& low, High& high) {
    low = static_cast<std::uint32_t>(value);
    high = static_cast<High>(value >> 32);
  }
};
static_assert(sizeof(VoxelRecord) == 32, "the map's memory is counted in these");

/// The voxels of one block of 4 x 4 x 4 that hold returns, by ascending key.
class VoxelBlock {
 public:
  bool empty() const { return mask_ == 0; }
  /// Bit i: whether voxel i of the block holds returns.
  std::uint64_t mask() const { return mask_; }
  int size() const;
  const VoxelRecord* begin() const { return records_.get(); }
  /// Bytes of the records, unused ones included.
  std::size_t bytes() const;

  /// The record of a voxel; nullptr where it holds no returns.
  VoxelRecord* find(int voxel);
  /// Makes empty records for the voxels of `mask` that have none; returns how many it made.
  int make(std::uint64_t mask);
  /// Calls the records of the voxels of `mask`, not empty, into the cache.
  void prefetch(std::uint64_t mask) const;
  void erase(int voxel);

 private:
  int rank(int voxel) const;
  void reserve(int from, int to);

  std::uint64_t mask_ = 0;
  std::unique_ptr<VoxelRecord[]> records_;
};

/// All voxels of a map: blocks in an open-addressing table, of which a scan touches few.
class VoxelTable {
 public:
  void add(const std::vector<VoxelContribution>& contributions);
  /// Takes one sum back; std::logic_error where it was never added.
  void subtract(const VoxelSum& sum);

  std::size_t size() const { return size_; }
  /// Calls `visit(const VoxelSum&)` for each voxel by ascending key.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const VoxelKey blockKey : sortedBlocks()) {
      const VoxelBlock& block = blocks_.find(blockKey)->second;
      const VoxelRecord* record = block.begin();
      for (std::uint64_t left = block.mask(); left != 0; left &= left - 1) {
        const auto voxel = static_cast<VoxelKey>(__builtin_ctzll(left));
        visit((record++)->sum(blockKey << kLocalBits | voxel));
      }
    }
  }
  std::size_t bytes() const;

 private:
  static constexpr int kLocalBits = 3 * kVoxelLocalBits;
  /// Blocks that are looked up together, so that the memory answers many questions at a time.
  static constexpr std::size_t kBatch = 32;
  /// Contributions in a row that go to one block, and the voxels they are for.
  struct Group {
    const VoxelContribution *begin, *end;
    VoxelKey blockKey;
    std::uint64_t mask;
    VoxelBlock* block;
  };
  struct Hash {
    std::size_t operator()(VoxelKey blockKey) const;
  };
  using Blocks = tsl::robin_map<VoxelKey, VoxelBlock, Hash>;
  static int voxelInBlock(VoxelKey key) { return static_cast<int>(key & ((1u << kLocalBits) - 1)); }
  static Group nextGroup(const VoxelContribution* first, const VoxelContribution* last);
  void addBatch(Group* first, Group* last);
  void addGroup(const Group& group, VoxelBlock& block);
  std::vector<VoxelKey> sortedBlocks() const;

  Blocks blocks_;
  std::size_t size_ = 0;
};

}  // namespace toss
