// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>
#include <tsl/robin_set.h>

namespace toss {

/// The sums of one voxel in 40 bytes: those of the offsets have 48 bits, enough for 2^32 returns.
struct VoxelRecord {
  VoxelKey key;
  std::uint64_t intensity;
  std::uint32_t count;
  std::uint32_t xLow, yLow, zLow;
  std::uint16_t xHigh, yHigh, zHigh;

  VoxelSum sum() const;
  void set(const VoxelSum& sum);
};
static_assert(sizeof(VoxelRecord) == 40, "the map's memory is counted in these");

/// All voxels: records in blocks that never move, in order of their coming (what one scan brings is
/// together in memory when the next one comes back to it), and an open-addressing index of them.
class VoxelTable {
 public:
  VoxelTable();
  VoxelTable(const VoxelTable&) = delete;
  VoxelTable& operator=(const VoxelTable&) = delete;

  /// The record of that voxel, or nullptr.
  VoxelRecord* find(VoxelKey key);
  /// The record of that voxel, made empty where there is none.
  VoxelRecord& findOrMake(VoxelKey key);
  void erase(VoxelKey key);

  std::size_t size() const { return index_.size(); }
  /// Calls `visit(const VoxelRecord&)` for each voxel, in no useful order.
  template <typename Visit>
  void visit(Visit&& visit) const {
    for (const Place place : index_) visit(records_.at(place));
  }
  std::size_t bytes() const;

 private:
  /// Where a record is; a type of its own, so that the index does not take it for a key.
  struct Place {
    std::uint32_t number;
  };
  struct Records {
    static constexpr int kBlockBits = 12;
    std::vector<std::unique_ptr<VoxelRecord[]>> blocks;

    VoxelRecord& at(Place place) const {
      return blocks[place.number >> kBlockBits][place.number & ((1u << kBlockBits) - 1)];
    }
  };
  struct Hash {
    const Records* records;
    std::size_t operator()(VoxelKey key) const;
    std::size_t operator()(Place place) const { return (*this)(records->at(place).key); }
  };
  struct Equal {
    using is_transparent = void;
    const Records* records;
    bool operator()(VoxelKey a, Place b) const { return a == records->at(b).key; }
    bool operator()(Place a, VoxelKey b) const { return records->at(a).key == b; }
    bool operator()(Place a, Place b) const { return a.number == b.number; }
  };
  Place newPlace();

  Records records_;
  std::vector<Place> free_;
  std::uint32_t made_ = 0;
  tsl::robin_set<Place, Hash, Equal, std::allocator<Place>, true> index_;
};

}  // namespace toss
