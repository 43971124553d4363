// SPDX-License-Identifier: BSD-3-Clause
// Voxels as bytes, while they are out of memory.
#include <cstring>

#include "VoxelBlocks.h"

namespace toss {

namespace {

void append(std::vector<std::uint8_t>& bytes, const void* from, std::size_t count) {
  const auto* const first = static_cast<const std::uint8_t*>(from);
  bytes.insert(bytes.end(), first, first + count);
}

const std::uint8_t* take(const std::uint8_t* bytes, void* to, std::size_t count) {
  std::memcpy(to, bytes, count);
  return bytes + count;
}

std::uint32_t voxelsIn(std::uint64_t mask) {
  return static_cast<std::uint32_t>(__builtin_popcountll(mask));
}

}  // namespace

void VoxelBlocks::save(std::vector<std::uint8_t>& bytes) const {
  bytes.clear();
  bytes.reserve(sizeof used_ + 2 * sizeof(VoxelKey) * used_ + sizeof(VoxelRecord) * size_);
  append(bytes, &used_, sizeof used_);
  for (const Block& block : slots_) {
    if (block.key == kNone) continue;
    append(bytes, &block.key, sizeof block.key);
    append(bytes, &block.mask, sizeof block.mask);
    const VoxelRecord* record = block.records;
    for (const VoxelRecord* const end = record + voxelsIn(block.mask); record != end; ++record) {
      append(bytes, record, sizeof *record);
      if (record->isReference()) append(bytes, &large_[record->place()], sizeof(VoxelSum));
    }
  }
}

void VoxelBlocks::restore(const std::vector<std::uint8_t>& bytes) {
  std::size_t blocks = 0;
  const std::uint8_t* next = take(bytes.data(), &blocks, sizeof blocks);
  grow(blocks + kBatch);
  for (; blocks > 0; --blocks) {
    VoxelKey key = 0;
    next = take(next, &key, sizeof key);
    Block& block = findOrMake(key, hash(key));
    next = take(next, &block.mask, sizeof block.mask);
    const std::uint32_t voxels = voxelsIn(block.mask);
    block.records = pool_.take(voxels);
    for (VoxelRecord* record = block.records; record != block.records + voxels; ++record) {
      next = take(next, static_cast<void*>(record), sizeof *record);
      if (!record->isReference()) continue;
      VoxelSum sum;
      next = take(next, &sum, sizeof sum);
      *record = VoxelRecord::reference(large_.insert(sum));
    }
    size_ += voxels;
  }
}

}  // namespace toss
