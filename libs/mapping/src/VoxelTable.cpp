// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTable.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace toss {

namespace {

VoxelBrick::Group nextGroup(const VoxelContribution* first, const VoxelContribution* last) {
  VoxelBrick::Group group{first, first};
  const VoxelKey brickKey = first->key >> kBrickShift;
  while (group.end != last && group.end->key >> kBrickShift == brickKey) ++group.end;
  return group;
}

VoxelKey brickKeyOf(const VoxelBrick::Group& group) {
  return group.begin->key >> kBrickShift;
}

}  // namespace

std::size_t VoxelTable::Hash::operator()(VoxelKey brickKey) const {
  brickKey *= 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(brickKey ^ brickKey >> 32);
}

void VoxelTable::add(const VoxelContribution* first, const VoxelContribution* last) {
  while (first != last) {
    std::array<VoxelBrick::Group, kBatch> batch;
    std::size_t count = 0;
    for (; count < kBatch && first != last; first = batch[count++].end)
      batch[count] = nextGroup(first, last);
    addBatch(batch.data(), batch.data() + count);
  }
}

void VoxelTable::addBatch(const VoxelBrick::Group* first, const VoxelBrick::Group* last) {
  std::array<VoxelBrick*, kBatch> known;
  for (const VoxelBrick::Group* group = first; group != last; ++group) {
    const auto place = bricks_.find(brickKeyOf(*group));
    VoxelBrick*& brick = known[static_cast<std::size_t>(group - first)];
    brick = place == bricks_.end() ? nullptr : &place.value();
    if (brick) brick->prefetchBlocks();
  }
  for (const VoxelBrick::Group* group = first; group != last; ++group)
    if (const VoxelBrick* const brick = known[static_cast<std::size_t>(group - first)])
      brick->prefetchRecords(*group);
  for (const VoxelBrick::Group* group = first; group != last; ++group)
    if (VoxelBrick* const brick = known[static_cast<std::size_t>(group - first)])
      size_ += brick->add(*group);
  // New bricks come last: they may move the others.
  for (const VoxelBrick::Group* group = first; group != last; ++group)
    if (!known[static_cast<std::size_t>(group - first)])
      size_ += bricks_[brickKeyOf(*group)].add(*group);
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
