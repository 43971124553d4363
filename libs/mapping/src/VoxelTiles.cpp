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

std::unique_ptr<VoxelBlocks> VoxelTiles::loaded(std::uint64_t tile) const {
  auto table = std::make_unique<VoxelBlocks>();
  std::vector<std::uint8_t> bytes;
  store_->load(tile, bytes);
  table->restore(bytes);
  return table;
}

VoxelBlocks& VoxelTiles::blocksOf(VoxelKey key) {
  const auto [place, isNew] = tiles_.try_emplace(key >> shift_);
  Tile& tile = place->second;
  if (isNew)
    tile.blocks = std::make_unique<VoxelBlocks>();
  else if (!tile.blocks)
    tile.blocks = loaded(place->first);
  tile.needed = calls_;
  return *tile.blocks;
}

void VoxelTiles::add(const RunSpan& runs, const std::vector<bool>* without) {
  std::array<const VoxelRun*, VoxelBlocks::kBatch> batch;
  std::size_t count = 0;
  for (const VoxelRun& run : runs) {
    batch[count] = &run;
    count += !without || !(*without)[run.owner()];
    if (count < batch.size()) continue;
    addBatch(batch.data(), batch.data() + count);
    count = 0;
  }
  addBatch(batch.data(), batch.data() + count);
}

void VoxelTiles::addBatch(const VoxelRun* const* first, const VoxelRun* const* last) {
  std::array<VoxelBlocks::Addition, VoxelBlocks::kBatch> additions;
  std::size_t count = 0;
  std::uint64_t tile = ~std::uint64_t{0};
  VoxelBlocks* blocks = nullptr;
  while (first != last) {
    const VoxelKey key = (*first)->key, block = key >> kBlockShift;
    if (key >> shift_ != tile) {
      tile = key >> shift_;
      blocks = &blocksOf(key);
      blocks->makeRoom();
    }
    blocks->prefetch(block);
    const VoxelRun* const* const firstOfBlock = first;
    while (first != last && (*first)->key >> kBlockShift == block) ++first;
    additions[count++] = {blocks, block, firstOfBlock, first, nullptr};
  }
  VoxelBlocks::add(additions.data(), additions.data() + count);
}

void VoxelTiles::subtract(const VoxelSum& sum) {
  blocksOf(sum.key).subtract(sum);
}

std::size_t VoxelTiles::size() const {
  std::size_t size = 0;
  for (const auto& [key, tile] : tiles_)
    size += tile.blocks ? tile.blocks->size() : tile.sizeInStore;
  return size;
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
    if (!tile.blocks || tile.needed + kCallsToStay > calls_ || !isFar(key, place, radius)) continue;
    tile.blocks->save(bytes_);
    store_->store(key, bytes_);
    tile.sizeInStore = tile.blocks->size();
    tile.blocks.reset();
  }
}

std::size_t VoxelTiles::tilesInMemory() const {
  return static_cast<std::size_t>(
      std::count_if(tiles_.begin(), tiles_.end(),
                    [](const auto& entry) { return entry.second.blocks != nullptr; }));
}

std::size_t VoxelTiles::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [key, tile] : tiles_)
    if (tile.blocks) bytes += tile.blocks->bytes();
  return bytes;
}

}  // namespace toss
