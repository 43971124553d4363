// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "VoxelTable.h"

namespace toss {

namespace {

/// Records that are allocated for `count` voxels: by a quarter at a time, so that a block that
/// fills up is seldom moved and little is left unused.
int capacityFor(int count) {
  int capacity = 2;
  while (capacity < count) capacity += std::max(1, capacity / 4);
  return count == 0 ? 0 : std::min(capacity, 64);
}

int firstOf(std::uint64_t bits) {
  return __builtin_ctzll(bits);
}

int lastOf(std::uint64_t bits) {
  return 63 - __builtin_clzll(bits);
}

int countBits(std::uint64_t bits) {
  return __builtin_popcountll(bits);
}

}  // namespace

int VoxelBlock::size() const {
  return countBits(mask_);
}

std::size_t VoxelBlock::bytes() const {
  return static_cast<std::size_t>(capacityFor(size())) * sizeof(VoxelRecord);
}

int VoxelBlock::rank(int voxel) const {
  return countBits(mask_ & ((std::uint64_t{1} << voxel) - 1));
}

VoxelRecord* VoxelBlock::find(int voxel) {
  return (mask_ >> voxel & 1) != 0 ? &records_[static_cast<std::size_t>(rank(voxel))] : nullptr;
}

void VoxelBlock::reserve(int from, int to) {
  if (capacityFor(from) == capacityFor(to)) return;
  std::unique_ptr<VoxelRecord[]> records;
  if (to > 0) records.reset(new VoxelRecord[static_cast<std::size_t>(capacityFor(to))]);
  std::copy_n(records_.get(), std::min(from, to), records.get());
  records_ = std::move(records);
}

void VoxelBlock::prefetch(std::uint64_t mask) const {
  constexpr std::size_t line = 64;
  const char* const first = reinterpret_cast<const char*>(&records_[0] + rank(firstOf(mask)));
  const char* const last = reinterpret_cast<const char*>(&records_[0] + rank(lastOf(mask)));
  for (const char* place = first; place <= last; place += line) __builtin_prefetch(place, 1);
}

int VoxelBlock::make(std::uint64_t mask) {
  const std::uint64_t added = mask & ~mask_;
  if (added == 0) return 0;
  const int before = size(), after = before + countBits(added);
  reserve(before, after);
  // From the back, so that every record moves straight to its new place.
  VoxelRecord* source = records_.get() + before;
  VoxelRecord* target = records_.get() + after;
  for (std::uint64_t left = mask_ | added; target != source;) {
    const std::uint64_t last = std::uint64_t{1} << lastOf(left);
    *--target = (added & last) != 0 ? VoxelRecord{} : *--source;
    left &= ~last;
  }
  mask_ |= added;
  return after - before;
}

void VoxelBlock::erase(int voxel) {
  const int count = size();
  VoxelRecord* const gap = records_.get() + rank(voxel);
  std::copy(gap + 1, records_.get() + count, gap);
  reserve(count, count - 1);
  mask_ &= ~(std::uint64_t{1} << voxel);
}

}  // namespace toss
