// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelBlocks.h"

#include <toss/geometry/ProcessorVariants.h>

#include <stdexcept>

namespace toss {

namespace {

[[noreturn]] void throwNeverAdded() {
  throw std::logic_error("VoxelMap: subtracts what was never added");
}

}  // namespace

bool VoxelBlocks::holds(VoxelKey voxel, int bits) const {
  if (slots_.empty()) return false;
  // Places of the cubes at the corner of a block.
  constexpr std::array<std::uint64_t, kBlockBits + 1> kCubes{1, 0x330033, ~std::uint64_t{0}};
  const VoxelKey block = cubeOf(voxel, kBlockBits);
  const std::uint64_t voxels = slots_[findSlot(block, hash(block))].mask;
  return (voxels >> placeInBlock(cubeOf(voxel, bits)) & kCubes[static_cast<std::size_t>(bits)]) !=
         0;
}

void VoxelBlocks::addLarge(VoxelRecord& record, const VoxelRun& run) {
  if (!record.isReference()) record = VoxelRecord::reference(large_.insert(record.sum(run.key)));
  VoxelSum& sum = large_[record.place()];
  sum.count += static_cast<std::uint32_t>(run.count());
  sum.x += run.x();
  sum.y += run.y();
  sum.z += run.z();
  sum.intensity += run.intensity();
}

TOSS_ALSO_FOR_AVX2
void VoxelBlocks::insert(Block& block, std::uint64_t voxels) {
  const std::uint32_t count = countBits(block.mask), added = countBits(voxels);
  VoxelRecord* const old = block.records;
  const bool moves = count + added > RecordPool::capacityFor(count);
  if (moves) block.records = pool_.take(count + added);
  // From the back, so that every record moves straight to its new place.
  const VoxelRecord* source = old + count;
  VoxelRecord* target = block.records + count + added;
  block.mask |= voxels;
  for (std::uint64_t left = block.mask; left != 0 && target != source;) {
    const std::uint64_t voxel = std::uint64_t{1} << (63 - __builtin_clzll(left));
    *--target = (voxels & voxel) != 0 ? VoxelRecord() : *--source;
    left &= ~voxel;
  }
  if (moves && count > 0) pool_.giveBack(old, count);
  size_ += added;
}

void VoxelBlocks::subtract(const VoxelSum& sum) {
  if (sum.count == 0) return;
  if (slots_.empty()) throwNeverAdded();
  const VoxelKey key = cubeOf(sum.key, kBlockBits);
  Block& block = slotOf(key, hash(key));
  const std::uint64_t bit = bitOf(sum.key);
  if ((block.mask & bit) == 0) throwNeverAdded();
  const std::uint32_t place = countBits(block.mask & (bit - 1));
  VoxelRecord& record = block.records[place];
  const VoxelSum s = sumOf(record, sum.key);
  if (s.count < sum.count || s.x < sum.x || s.y < sum.y || s.z < sum.z ||
      s.intensity < sum.intensity)
    throwNeverAdded();
  setLess(record, {sum.key, s.count - sum.count, s.x - sum.x, s.y - sum.y, s.z - sum.z,
                   s.intensity - sum.intensity});
  if (s.count == sum.count) erase(block, bit);
}

void VoxelBlocks::setLess(VoxelRecord& record, const VoxelSum& left) {
  if (left.count > VoxelRecord::kMostReturns) {
    large_[record.place()] = left;
    return;
  }
  if (record.isReference()) large_.erase(record.place());
  record = VoxelRecord(left);
}

void VoxelBlocks::erase(Block& block, std::uint64_t voxel) {
  const std::uint32_t count = countBits(block.mask), place = countBits(block.mask & (voxel - 1));
  VoxelRecord* const old = block.records;
  const bool smaller = RecordPool::capacityFor(count - 1) != RecordPool::capacityFor(count);
  if (smaller && count > 1) block.records = pool_.take(count - 1);
  if (smaller) std::copy_n(old, place, block.records);
  std::copy(old + place + 1, old + count, block.records + place);
  if (smaller) pool_.giveBack(old, count);
  block.mask &= ~voxel;
  --size_;
  if (block.mask == 0) eraseBlock(block);
}

void VoxelBlocks::eraseBlock(Block& block) {
  const auto home = [&](const Block& each) { return hash(each.key) >> hashShift_; };
  auto gap = static_cast<std::size_t>(&block - slots_.data());
  // Blocks behind the gap move into it where that is not before their home.
  for (std::size_t next = (gap + 1) & lastSlot_; slots_[next].key != kNone;
       next = (next + 1) & lastSlot_) {
    const std::size_t fromHome = (next - home(slots_[next])) & lastSlot_;
    if (fromHome < ((next - gap) & lastSlot_)) continue;
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
  lastSlot_ = old.size() - 1;
  old.swap(slots_);
  for (const Block& block : old)
    if (block.key != kNone) slotOf(block.key, hash(block.key)) = block;
}

std::vector<const VoxelBlocks::Block*> VoxelBlocks::sortedBlocks() const {
  std::vector<std::pair<std::uint64_t, const Block*>> placed;
  placed.reserve(used_);
  for (const Block& block : slots_)
    if (block.key != kNone) placed.emplace_back(placeInMap(block.key), &block);
  std::sort(placed.begin(), placed.end());
  std::vector<const Block*> blocks;
  blocks.reserve(used_);
  for (const auto& [place, block] : placed) blocks.push_back(block);
  return blocks;
}

}  // namespace toss
