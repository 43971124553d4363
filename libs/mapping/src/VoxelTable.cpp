// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTable.h"

#include <algorithm>
#include <stdexcept>

namespace toss {

namespace {

VoxelKey brickKeyOf(const VoxelTable::Addition& addition) {
  return addition.first->begin->key >> kBrickShift;
}

}  // namespace

std::size_t VoxelTable::Hash::operator()(VoxelKey brickKey) const {
  brickKey *= 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(brickKey ^ brickKey >> 32);
}

std::size_t VoxelTable::add(Addition* first, Addition* last) {
  for (Addition* addition = first; addition != last; ++addition) {
    auto& bricks = addition->table->bricks_;
    const auto place = bricks.find(brickKeyOf(*addition));
    addition->brick = place == bricks.end() ? nullptr : &place.value();
    if (addition->brick) addition->brick->prefetchBlocks();
  }
  for (const Addition* addition = first; addition != last; ++addition)
    if (addition->brick)
      for (const VoxelBrick::Group* group = addition->first; group != addition->last; ++group)
        addition->brick->prefetchRecords(*group);
  std::size_t added = 0;
  for (const Addition* addition = first; addition != last; ++addition)
    if (addition->brick) added += addition->table->add(*addition, *addition->brick);
  // New bricks come last: they may move the others.
  for (const Addition* addition = first; addition != last; ++addition)
    if (!addition->brick)
      added += addition->table->add(*addition, addition->table->bricks_[brickKeyOf(*addition)]);
  return added;
}

std::uint32_t VoxelTable::add(const Addition& addition, VoxelBrick& brick) {
  const std::uint32_t added = brick.add(addition.first, addition.last);
  size_ += added;
  return added;
}

void VoxelTable::subtract(const VoxelSum& sum) {
  const auto place = bricks_.find(sum.key >> kBrickShift);
  if (place == bricks_.end()) {
    if (sum.count > 0) throw std::logic_error("VoxelMap: subtracts what was never added");
    return;
  }
  size_ -= place.value().subtract(sum);
  if (place->second.empty()) bricks_.erase(place);
}

std::vector<VoxelKey> VoxelTable::sortedBricks() const {
  std::vector<VoxelKey> keys;
  keys.reserve(bricks_.size());
  for (const auto& [key, brick] : bricks_) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

std::size_t VoxelTable::bytes() const {
  // A slot of the table holds its distance from home beside key and brick.
  constexpr std::size_t slot = sizeof(std::uint64_t) + sizeof(VoxelKey) + sizeof(VoxelBrick);
  std::size_t bytes = bricks_.bucket_count() * slot;
  for (const auto& [key, brick] : bricks_) bytes += brick.bytes();
  return bytes;
}

}  // namespace toss
