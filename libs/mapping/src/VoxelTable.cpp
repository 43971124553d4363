// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTable.h"

#include <algorithm>
#include <stdexcept>

namespace toss {

std::size_t VoxelTable::Hash::operator()(VoxelKey blockKey) const {
  blockKey *= 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(blockKey ^ blockKey >> 32);
}

VoxelTable::Group VoxelTable::nextGroup(const VoxelContribution* first,
                                        const VoxelContribution* last) {
  Group group{first, first, first->key >> kLocalBits, 0, nullptr};
  for (; group.end != last && group.end->key >> kLocalBits == group.blockKey; ++group.end) {
    group.mask |= std::uint64_t{1} << voxelInBlock(group.end->key);
  }
  return group;
}

void VoxelTable::add(const std::vector<VoxelContribution>& contributions) {
  const VoxelContribution* next = contributions.data();
  const VoxelContribution* const last = next + contributions.size();
  while (next != last) {
    std::array<Group, kBatch> batch;
    std::size_t count = 0;
    for (; count < kBatch && next != last; next = batch[count++].end) {
      batch[count] = nextGroup(next, last);
    }
    addBatch(batch.data(), batch.data() + count);
  }
}

void VoxelTable::addBatch(Group* first, Group* last) {
  for (Group* group = first; group != last; ++group) {
    const auto place = blocks_.find(group->blockKey);
    if (place == blocks_.end()) continue;
    group->block = &place.value();
    group->block->prefetch(group->mask);
  }
  // New blocks come last: they may move the others.
  for (Group* group = first; group != last; ++group) {
    if (group->block) addGroup(*group, *group->block);
  }
  for (Group* group = first; group != last; ++group) {
    if (!group->block) addGroup(*group, blocks_[group->blockKey]);
  }
}

void VoxelTable::addGroup(const Group& group, VoxelBlock& block) {
  size_ += static_cast<std::size_t>(block.make(group.mask));
  for (const VoxelContribution* c = group.begin; c != group.end; ++c) {
    VoxelRecord& record = *block.find(voxelInBlock(c->key));
    const VoxelSum s = record.sum(c->key);
    record.set({c->key, s.count + c->count, s.x + c->x, s.y + c->y, s.z + c->z,
                s.intensity + c->intensity});
  }
}

void VoxelTable::subtract(const VoxelSum& sum) {
  const auto place = blocks_.find(sum.key >> kLocalBits);
  const int voxel = voxelInBlock(sum.key);
  VoxelRecord* const record = place == blocks_.end() ? nullptr : place.value().find(voxel);
  const VoxelSum s = record ? record->sum(sum.key) : VoxelSum();
  if (s.count < sum.count || s.x < sum.x || s.y < sum.y || s.z < sum.z ||
      s.intensity < sum.intensity) {
    throw std::logic_error("VoxelMap: subtracts what was never added");
  }
  if (!record) return;
  record->set({sum.key, s.count - sum.count, s.x - sum.x, s.y - sum.y, s.z - sum.z,
               s.intensity - sum.intensity});
  if (record->count > 0) return;
  place.value().erase(voxel);
  --size_;
  if (place->second.empty()) blocks_.erase(place);
}

std::vector<VoxelKey> VoxelTable::sortedBlocks() const {
  std::vector<VoxelKey> keys;
  keys.reserve(blocks_.size());
  for (const auto& [key, block] : blocks_) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

std::size_t VoxelTable::bytes() const {
  // A slot of the table holds its distance from home beside key and block; an allocation of
  // records costs its capacity and a header of the size of a pointer.
  constexpr std::size_t slot = sizeof(std::uint64_t) + sizeof(VoxelKey) + sizeof(VoxelBlock);
  std::size_t bytes = blocks_.bucket_count() * slot;
  for (const auto& [key, block] : blocks_) bytes += block.bytes() + sizeof(void*);
  return bytes;
}

}  // namespace toss
