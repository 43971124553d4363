// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTiles.h"

#include <algorithm>
#include <cmath>

namespace toss {

namespace {

/// Calls of leaveBehind() for which a tile stays that was needed: labels are revised in bursts.
constexpr std::uint64_t kCallsToStay = 50;

}  // namespace

VoxelTiles::VoxelTiles(double tileVoxels, TileStore* store) : store_(store) {
  if (!store || tileVoxels <= 0.0) return;
  int doublings = 0;
  while (kBrickVoxels * std::ldexp(1.0, doublings) < tileVoxels && doublings < 17) ++doublings;
  shift_ = kBrickShift + 3 * doublings;
}

std::unique_ptr<VoxelTable> VoxelTiles::loaded(std::uint64_t tile) const {
  auto table = std::make_unique<VoxelTable>();
  std::vector<std::uint8_t> bytes;
  store_->load(tile, bytes);
  table->restore(bytes);
  return table;
}

VoxelTiles::Tile& VoxelTiles::tileOf(VoxelKey key) {
  const auto [place, isNew] = tiles_.try_emplace(key >> shift_);
  Tile& tile = place->second;
  if (isNew)
    tile.table = std::make_unique<VoxelTable>();
  else if (!tile.table)
    tile.table = loaded(place->first);
  tile.needed = calls_;
  return tile;
}

void VoxelTiles::groupByBrick(const ContributionSpan* first, const ContributionSpan* last) {
  groups_.clear();
  for (const ContributionSpan* span = first; span != last; ++span)
    for (const VoxelContribution* next = span->begin; next != span->end;) {
      VoxelBrick::Group& group = groups_.emplace_back(VoxelBrick::Group{next, next});
      const VoxelKey brick = next->key >> kBrickShift;
      while (next != span->end && next->key >> kBrickShift == brick) ++next;
      group.end = next;
    }
  std::sort(groups_.begin(), groups_.end(), [](const auto& a, const auto& b) {
    return a.begin->key >> kBrickShift < b.begin->key >> kBrickShift;
  });
}

void VoxelTiles::add(const ContributionSpan* first, const ContributionSpan* last) {
  groupByBrick(first, last);
  std::array<VoxelTable::Addition, kBatch> batch;
  std::size_t count = 0;
  std::uint64_t tile = 0;
  VoxelTable* table = nullptr;
  const VoxelBrick::Group* const end = groups_.data() + groups_.size();
  for (const VoxelBrick::Group* group = groups_.data(); group != end;) {
    const VoxelKey key = group->begin->key;
    if (!table || key >> shift_ != tile) table = tileOf(key).table.get();
    tile = key >> shift_;
    const VoxelBrick::Group* const firstOfBrick = group;
    while (group != end && group->begin->key >> kBrickShift == key >> kBrickShift) ++group;
    batch[count++] = {table, firstOfBrick, group, nullptr};
    if (count < kBatch && group != end) continue;
    size_ += VoxelTable::add(batch.data(), batch.data() + count);
    count = 0;
  }
}

void VoxelTiles::subtract(const VoxelSum& sum) {
  VoxelTable& table = *tileOf(sum.key).table;
  const std::size_t before = table.size();
  table.subtract(sum);
  size_ -= before - table.size();
}

bool VoxelTiles::isFar(std::uint64_t tile, const std::array<double, 3>& place,
                       double radius) const {
  const double edge = kBrickVoxels * std::ldexp(1.0, (shift_ - kBrickShift) / 3);
  const std::array<std::int32_t, 3> corner = voxelIndex(tile << shift_);
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = static_cast<double>(corner[axis]) + kVoxelReach;
    const double gap = std::max({low - place[axis], place[axis] - (low + edge), 0.0});
    squared += gap * gap;
  }
  return squared > radius * radius;
}

void VoxelTiles::leaveBehind(const std::array<double, 3>& place, double radius) {
  if (shift_ == 63) return;
  ++calls_;
  for (auto& [key, tile] : tiles_) {
    if (!tile.table || tile.needed + kCallsToStay > calls_ || !isFar(key, place, radius)) continue;
    tile.table->save(bytes_);
    store_->store(key, bytes_);
    tile.table.reset();
  }
}

std::size_t VoxelTiles::tilesInMemory() const {
  return static_cast<std::size_t>(
      std::count_if(tiles_.begin(), tiles_.end(),
                    [](const auto& entry) { return entry.second.table != nullptr; }));
}

std::size_t VoxelTiles::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, tile] : tiles_)
    if (tile.table) bytes += tile.table->bytes();
  return bytes;
}

}  // namespace toss
