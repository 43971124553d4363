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

void VoxelTiles::add(const VoxelContribution* first, const VoxelContribution* last) {
  while (first != last) {
    const VoxelContribution* end = last;
    if ((last - 1)->key >> shift_ != first->key >> shift_) {
      const VoxelKey next = ((first->key >> shift_) + 1) << shift_;
      end = std::partition_point(first, last,
                                 [next](const VoxelContribution& c) { return c.key < next; });
    }
    VoxelTable& table = *tileOf(first->key).table;
    const std::size_t before = table.size();
    table.add(first, end);
    size_ += table.size() - before;
    first = end;
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
