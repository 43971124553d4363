// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBrick.h"

#include <algorithm>
#include <stdexcept>

namespace toss {

namespace {

std::uint64_t bitOf(VoxelKey place) {
  return std::uint64_t{1} << (place & 63);
}

std::uint64_t lowestBit(std::uint64_t mask) {
  return mask & (0 - mask);
}

int firstOf(std::uint64_t mask) {
  return __builtin_ctzll(mask);
}

/// Room for growth: a brick that fills up is seldom moved, and little is left unused.
std::uint32_t capacityFor(std::uint32_t size) {
  return size + size / 4 + 2;
}

}  // namespace

std::uint32_t VoxelBrick::add(const Group* first, const Group* last) {
  std::uint64_t added[64] = {}, addedBlocks = 0;
  const std::uint32_t before = size_;
  for (const Group* group = first; group != last; ++group) {
    for (const VoxelContribution* c = group->begin; c != group->end;) {
      const VoxelKey blockKey = c->key >> kBlockShift;
      std::uint64_t mask = 0;
      for (; c != group->end && c->key >> kBlockShift == blockKey; ++c) mask |= bitOf(c->key);
      const Block* const block = find(blockKey << kBlockShift);
      if (block) mask &= ~block->mask;
      added[blockKey & 63] |= mask;
      if (mask != 0) addedBlocks |= bitOf(blockKey);
    }
  }
  if (addedBlocks != 0) make(added, addedBlocks);
  for (const Group* group = first; group != last; ++group) addToRecords(*group);
  return size_ - before;
}

void VoxelBrick::addToRecords(const Group& group) {
  for (const VoxelContribution* c = group.begin; c != group.end;) {
    const VoxelKey blockKey = c->key >> kBlockShift;
    const Block block = *find(c->key);
    for (; c != group.end && c->key >> kBlockShift == blockKey; ++c)
      records_[block.first + countBits(block.mask & (bitOf(c->key) - 1))].add(*c);
  }
}

void VoxelBrick::make(const std::uint64_t* added, std::uint64_t addedBlocks) {
  Block blocks[64];
  std::uint64_t addedOf[64] = {};
  const std::uint64_t all = blockMask_ | addedBlocks;
  const Block* old = blocks_.get();
  int count = 0;
  std::uint32_t size = 0;
  for (std::uint64_t left = all; left != 0; left &= left - 1, ++count) {
    addedOf[count] = (addedBlocks & lowestBit(left)) != 0 ? added[firstOf(left)] : 0;
    const std::uint64_t known = (blockMask_ & lowestBit(left)) != 0 ? (old++)->mask : 0;
    blocks[count] = {known | addedOf[count], size};
    size += countBits(blocks[count].mask);
  }
  moveRecords(blocks, count, addedOf, size);
  if (all != blockMask_) blocks_.reset(new Block[static_cast<std::size_t>(count)]);
  std::copy_n(blocks, count, blocks_.get());
  blockMask_ = all;
}

void VoxelBrick::moveRecords(const Block* blocks, int count, const std::uint64_t* addedOf,
                             std::uint32_t newSize) {
  const std::uint32_t before = size_;
  reserve(newSize);
  // From the back, so that every record moves straight to its new place.
  const VoxelRecord* source = records_.get() + before;
  VoxelRecord* target = records_.get() + newSize;
  for (int b = count - 1; b >= 0; --b) {
    std::uint64_t left = blocks[b].mask;
    for (std::uint64_t added = addedOf[b]; added != 0;) {
      const std::uint64_t last = std::uint64_t{1} << (63 - __builtin_clzll(added));
      const std::uint32_t above = countBits(left & ~(last | (last - 1)));
      target = std::copy_backward(source - above, source, target);
      source -= above;
      *--target = VoxelRecord{};
      left &= last - 1;
      added &= last - 1;
    }
    // What is left lies where it is to be.
    if (target == source) break;
    const std::uint32_t rest = countBits(left);
    target = std::copy_backward(source - rest, source, target);
    source -= rest;
  }
  size_ = newSize;
}

void VoxelBrick::reserve(std::uint32_t size) {
  if (size <= capacity_ && 2 * size >= capacity_) return;
  capacity_ = capacityFor(size);
  std::unique_ptr<VoxelRecord[]> records(new VoxelRecord[capacity_]);
  std::copy_n(records_.get(), std::min(size, size_), records.get());
  records_ = std::move(records);
}

std::uint32_t VoxelBrick::subtract(const VoxelSum& sum) {
  Block* const block = find(sum.key);
  const bool known = block && (block->mask & bitOf(sum.key)) != 0;
  VoxelRecord* const record =
      known ? &records_[block->first + countBits(block->mask & (bitOf(sum.key) - 1))] : nullptr;
  const VoxelSum s = record ? record->sum(sum.key) : VoxelSum();
  if (s.count < sum.count || s.x < sum.x || s.y < sum.y || s.z < sum.z ||
      s.intensity < sum.intensity)
    throw std::logic_error("VoxelMap: subtracts what was never added");
  if (!record) return 0;
  record->set({sum.key, s.count - sum.count, s.x - sum.x, s.y - sum.y, s.z - sum.z,
               s.intensity - sum.intensity});
  if (record->count > 0) return 0;
  erase(sum.key, *block);
  return 1;
}

void VoxelBrick::erase(VoxelKey key, Block& block) {
  const std::uint32_t gap = block.first + countBits(block.mask & (bitOf(key) - 1));
  std::copy(&records_[gap] + 1, records_.get() + size_, &records_[gap]);
  reserve(--size_);
  const auto blockCount = countBits(blockMask_);
  block.mask &= ~bitOf(key);
  for (Block* later = &block + 1; later != blocks_.get() + blockCount; ++later) --later->first;
  if (block.mask != 0) return;
  std::copy(&block + 1, blocks_.get() + blockCount, &block);
  blockMask_ &= ~bitOf(key >> kBlockShift);
}

void VoxelBrick::prefetchRecords(const Group& group) const {
  for (const VoxelContribution* c = group.begin; c != group.end;) {
    const VoxelKey blockKey = c->key >> kBlockShift;
    const Block* const block = find(c->key);
    const VoxelRecord* last = nullptr;
    for (; c != group.end && c->key >> kBlockShift == blockKey; ++c) {
      if (!block) continue;
      const VoxelRecord* record =
          &records_[block->first + countBits(block->mask & (bitOf(c->key) - 1))];
      if (record > last) __builtin_prefetch(record, 1);
      last = record + 1;
    }
  }
}

std::size_t VoxelBrick::bytes() const {
  // Each of the two runs of memory costs a header of the size of a pointer too.
  return countBits(blockMask_) * sizeof(Block) + capacity_ * sizeof(VoxelRecord) +
         2 * sizeof(void*);
}

}  // namespace toss
