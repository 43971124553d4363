// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBlocks.h"

#include <stdexcept>

namespace toss {

namespace {

std::uint64_t bitOf(VoxelKey key) {
  return std::uint64_t{1} << (key & ((1u << kBlockShift) - 1));
}

/// Bits of a word that are set. Processors without an instruction for it are to run the program
/// too, and a call for each voxel takes longer than this.
std::uint32_t countBits(std::uint64_t v) {
  v -= v >> 1 & 0x5555555555555555u;
  v = (v & 0x3333333333333333u) + (v >> 2 & 0x3333333333333333u);
  v = (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<std::uint32_t>(v * 0x0101010101010101u >> 56);
}

[[noreturn]] void throwNeverAdded() {
  throw std::logic_error("VoxelMap: subtracts what was never added");
}

}  // namespace

void VoxelBlocks::prefetchRecords(const Addition& addition) {
  const Block& block = *addition.block;
  for (const VoxelRun* const* run = addition.first; run != addition.last; ++run)
    __builtin_prefetch(block.records + countBits(block.mask & (bitOf((*run)->key) - 1)), 1);
}

void VoxelBlocks::addToRecords(const Addition& addition) {
  Block& block = *addition.block;
  for (const VoxelRun* const* run = addition.first; run != addition.last; ++run) {
    const std::uint64_t bit = bitOf((*run)->key);
    const std::uint32_t place = countBits(block.mask & (bit - 1));
    if ((block.mask & bit) == 0) addition.blocks->insert(block, bit, place);
    block.records[place].add(**run);
  }
}

void VoxelBlocks::add(Addition* first, Addition* last) {
  for (Addition* addition = first; addition != last; ++addition) {
    addition->block = &addition->blocks->findOrMake(addition->key);
    prefetchRecords(*addition);
  }
  for (const Addition* addition = first; addition != last; ++addition) addToRecords(*addition);
}

void VoxelBlocks::insert(Block& block, std::uint64_t bit, std::uint32_t place) {
  const std::uint32_t count = countBits(block.mask);
  VoxelRecord* const old = block.records;
  if (count == RecordPool::capacityFor(count)) {
    block.records = pool_.take(count + 1);
    std::copy_n(old, place, block.records);
    std::copy(old + place, old + count, block.records + place + 1);
    if (count > 0) pool_.giveBack(old, count);
  } else {
    std::copy_backward(old + place, old + count, old + count + 1);
  }
  block.records[place] = VoxelRecord();
  block.mask |= bit;
  ++size_;
}

void VoxelBlocks::subtract(const VoxelSum& sum) {
  if (sum.count == 0) return;
  if (slots_.empty()) throwNeverAdded();
  Block& block = slotOf(sum.key >> kBlockShift);
  const std::uint64_t bit = bitOf(sum.key);
  if ((block.mask & bit) == 0) throwNeverAdded();
  const std::uint32_t place = countBits(block.mask & (bit - 1));
  const VoxelSum s = block.records[place].sum(sum.key);
  if (s.count < sum.count || s.x < sum.x || s.y < sum.y || s.z < sum.z ||
      s.intensity < sum.intensity)
    throwNeverAdded();
  block.records[place].set({sum.key, s.count - sum.count, s.x - sum.x, s.y - sum.y, s.z - sum.z,
                            s.intensity - sum.intensity});
  if (s.count == sum.count) erase(block, bit, place);
}

void VoxelBlocks::erase(Block& block, std::uint64_t bit, std::uint32_t place) {
  const std::uint32_t count = countBits(block.mask);
  VoxelRecord* const old = block.records;
  const bool smaller = RecordPool::capacityFor(count - 1) != RecordPool::capacityFor(count);
  if (smaller && count > 1) block.records = pool_.take(count - 1);
  if (smaller) std::copy_n(old, place, block.records);
  std::copy(old + place + 1, old + count, block.records + place);
  if (smaller) pool_.giveBack(old, count);
  block.mask &= ~bit;
  --size_;
  if (block.mask == 0) eraseBlock(block);
}

void VoxelBlocks::eraseBlock(Block& block) {
  const std::size_t last = slots_.size() - 1;
  auto gap = static_cast<std::size_t>(&block - slots_.data());
  // Blocks behind the gap move into it where that is not before their home.
  for (std::size_t next = (gap + 1) & last; slots_[next].key != kNone; next = (next + 1) & last) {
    const std::size_t fromHome = (next - home(slots_[next].key)) & last;
    if (fromHome < ((next - gap) & last)) continue;
    slots_[gap] = slots_[next];
    gap = next;
  }
  slots_[gap] = Block();
  --used_;
}

void VoxelBlocks::grow(std::size_t blocks) {
  constexpr std::size_t kLeastBits = 7;
  std::size_t bits = kLeastBits;
  while (blocks * 3 > (std::size_t{2} << bits)) ++bits;
  hashShift_ = static_cast<int>(64 - bits);
  std::vector<Block> old(std::size_t{1} << bits);
  old.swap(slots_);
  for (const Block& block : old)
    if (block.key != kNone) slotOf(block.key) = block;
}

std::vector<const VoxelBlocks::Block*> VoxelBlocks::sortedBlocks() const {
  std::vector<const Block*> blocks;
  blocks.reserve(used_);
  for (const Block& block : slots_)
    if (block.key != kNone) blocks.push_back(&block);
  std::sort(blocks.begin(), blocks.end(),
            [](const Block* a, const Block* b) { return a->key < b->key; });
  return blocks;
}

}  // namespace toss
