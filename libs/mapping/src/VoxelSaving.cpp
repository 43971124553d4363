// SPDX-License-Identifier: BSD-3-Clause
// Bricks and tables as bytes, while they are out of memory.
#include <cstring>

#include "VoxelTable.h"

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

}  // namespace

void VoxelBrick::save(std::vector<std::uint8_t>& bytes) const {
  append(bytes, &blockMask_, sizeof blockMask_);
  append(bytes, &size_, sizeof size_);
  append(bytes, blocks_.get(), countBits(blockMask_) * sizeof(Block));
  append(bytes, records_.get(), size_ * sizeof(VoxelRecord));
}

const std::uint8_t* VoxelBrick::restore(const std::uint8_t* bytes) {
  bytes = take(bytes, &blockMask_, sizeof blockMask_);
  std::uint32_t size = 0;
  bytes = take(bytes, &size, sizeof size);
  reserve(size);
  size_ = size;
  const std::size_t blocks = countBits(blockMask_);
  blocks_.reset(new Block[blocks]);
  bytes = take(bytes, blocks_.get(), blocks * sizeof(Block));
  return take(bytes, records_.get(), size_ * sizeof(VoxelRecord));
}

void VoxelTable::save(std::vector<std::uint8_t>& bytes) const {
  bytes.clear();
  for (const VoxelKey key : sortedBricks()) {
    append(bytes, &key, sizeof key);
    bricks_.find(key)->second.save(bytes);
  }
}

void VoxelTable::restore(const std::vector<std::uint8_t>& bytes) {
  const std::uint8_t* next = bytes.data();
  const std::uint8_t* const end = next + bytes.size();
  while (next != end) {
    VoxelKey key = 0;
    next = take(next, &key, sizeof key);
    VoxelBrick& brick = bricks_[key];
    next = brick.restore(next);
    size_ += brick.size();
  }
}

}  // namespace toss
