// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTable.h"

#include <limits>
#include <stdexcept>

namespace toss {

namespace {

/// Full index slots are cheap to skip, empty ones cost memory.
constexpr float kLargestLoad = 0.9f;

std::uint64_t wide(std::uint32_t low, std::uint16_t high) {
  return static_cast<std::uint64_t>(high) << 32 | low;
}

void split(std::uint64_t value, std::uint32_t& low, std::uint16_t& high) {
  low = static_cast<std::uint32_t>(value);
  high = static_cast<std::uint16_t>(value >> 32);
}

}  // namespace

VoxelSum VoxelRecord::sum() const {
  return {key, count, wide(xLow, xHigh), wide(yLow, yHigh), wide(zLow, zHigh), intensity};
}

void VoxelRecord::set(const VoxelSum& sum) {
  count = sum.count;
  split(sum.x, xLow, xHigh);
  split(sum.y, yLow, yHigh);
  split(sum.z, zLow, zHigh);
  intensity = sum.intensity;
}

std::size_t VoxelTable::Hash::operator()(VoxelKey key) const {
  key *= 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(key ^ key >> 32);
}

VoxelTable::VoxelTable() : index_(0, Hash{&records_}, Equal{&records_}) {
  index_.max_load_factor(kLargestLoad);
}

VoxelRecord* VoxelTable::find(VoxelKey key) {
  const auto found = index_.find(key);
  return found == index_.end() ? nullptr : &records_.at(*found);
}

VoxelRecord& VoxelTable::findOrMake(VoxelKey key) {
  if (VoxelRecord* const found = find(key)) return *found;
  const Place place = newPlace();
  VoxelRecord& record = records_.at(place);
  record = VoxelRecord{};
  record.key = key;
  index_.insert(place);
  return record;
}

void VoxelTable::erase(VoxelKey key) {
  const auto found = index_.find(key);
  if (found == index_.end()) return;
  free_.push_back(*found);
  index_.erase(found);
}

VoxelTable::Place VoxelTable::newPlace() {
  if (!free_.empty()) {
    const Place place = free_.back();
    free_.pop_back();
    return place;
  }
  if (made_ == std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("VoxelTable: more than 2^32 voxels");
  }
  if (made_ >> Records::kBlockBits == records_.blocks.size()) {
    records_.blocks.emplace_back(new VoxelRecord[std::size_t{1} << Records::kBlockBits]);
  }
  return {made_++};
}

std::size_t VoxelTable::bytes() const {
  // tsl keeps the truncated hash, the distance from the home slot and the value of every slot.
  struct Slot {
    std::uint32_t hash;
    std::int16_t distance;
    bool last;
    Place place;
  };
  return index_.bucket_count() * sizeof(Slot) + free_.capacity() * sizeof(Place) +
         (records_.blocks.size() << Records::kBlockBits) * sizeof(VoxelRecord) +
         records_.blocks.capacity() * sizeof(records_.blocks[0]);
}

}  // namespace toss
