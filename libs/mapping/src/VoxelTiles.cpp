// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelTiles.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>

namespace toss {

namespace {

/// Calls of leaveBehind() for which a tile stays that was needed: labels are revised in bursts.
constexpr std::uint64_t kCallsToStay = 50;

/// Bytes of tiles put into the store after which their memory goes back to the system: the C
/// library keeps what lies between pieces still needed, and to look for it all takes some
/// milliseconds.
constexpr std::size_t kBytesToGiveBack = std::size_t{32} << 20;

void giveBackToSystem() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace

VoxelTiles::VoxelTiles(double tileVoxels, TileStore* store) : store_(store) {
  if (!store || tileVoxels <= 0.0) return;
  int doublings = 0;
  while (kBrickVoxels * std::ldexp(1.0, doublings) < tileVoxels && doublings < 17) ++doublings;
  tileBits_ = kBrickBits + doublings;
  placeShift_ = 3 * (tileBits_ - kBlockBits);
}

std::unique_ptr<VoxelBlocks> VoxelTiles::loaded(std::uint64_t tile) const {
  auto table = std::make_unique<VoxelBlocks>();
  std::vector<std::uint8_t> bytes;
  store_->load(tile, bytes);
  table->restore(bytes);
  return table;
}

VoxelBlocks& VoxelTiles::blocksOf(VoxelKey firstOfTile) {
  const auto [place, isNew] = tiles_.try_emplace(placeOf(firstOfTile));
  Tile& tile = place->second;
  tile.key = firstOfTile;
  if (isNew)
    tile.blocks = std::make_unique<VoxelBlocks>();
  else if (!tile.blocks)
    tile.blocks = loaded(place->first);
  tile.needed = calls_;
  return *tile.blocks;
}

void VoxelTiles::add(const RunSpan& runs, const std::vector<bool>* without) {
  const auto isLeftOut = [&](const VoxelRun& run) { return without && (*without)[run.owner()]; };
  for (const VoxelRun *run = runs.begin(), *end; run != runs.end(); run = end) {
    for (end = run; end != runs.end() && !isLeftOut(*end);) ++end;
    addAll({run, end});
    while (end != runs.end() && isLeftOut(*end)) ++end;
  }
}

void VoxelTiles::addAll(const RunSpan& runs) {
  constexpr std::ptrdiff_t kMost = VoxelBlocks::kBatch;
  for (const VoxelRun *run = runs.begin(), *end; run != runs.end(); run = end) {
    const VoxelKey tile = cubeOf(run->key, tileBits_);
    const VoxelRun* const most = run + std::min(kMost, runs.end() - run);
    for (end = run; end != most && cubeOf(end->key, tileBits_) == tile;) ++end;
    blocksOf(tile).add(run, end);
  }
}

void VoxelTiles::subtract(const RunSpan& runs) {
  constexpr std::ptrdiff_t kTogether = 32;
  for (const VoxelRun *run = runs.begin(), *end; run != runs.end(); run = end) {
    const VoxelKey tile = cubeOf(run->key, tileBits_);
    VoxelBlocks& blocks = blocksOf(tile);
    const VoxelRun* const most = run + std::min(kTogether, runs.end() - run);
    const bool holdsAny = blocks.size() > 0;
    for (end = run; end != most && cubeOf(end->key, tileBits_) == tile; ++end)
      if (holdsAny) blocks.prefetch(VoxelBlocks::hash(cubeOf(end->key, kBlockBits)));
    for (; run != end; ++run)
      blocks.subtract({run->key, static_cast<std::uint32_t>(run->count()), run->x(), run->y(),
                       run->z(), run->intensity()});
  }
}

void VoxelTiles::subtract(const VoxelSum& sum) {
  blocksOf(cubeOf(sum.key, tileBits_)).subtract(sum);
}

bool VoxelTiles::holds(VoxelKey voxel, int bits) {
  const VoxelKey tile = cubeOf(voxel, tileBits_);
  const auto found = tiles_.find(placeOf(tile));
  if (found == tiles_.end()) return false;
  if (!found->second.blocks) return blocksOf(tile).holds(voxel, bits);
  found->second.needed = calls_;
  return found->second.blocks->holds(voxel, bits);
}

std::size_t VoxelTiles::size() const {
  std::size_t size = 0;
  for (const auto& [key, tile] : tiles_)
    size += tile.blocks ? tile.blocks->size() : tile.sizeInStore;
  return size;
}

bool VoxelTiles::isFar(VoxelKey tile, const std::array<double, 3>& place, double radius) const {
  const double edge = std::ldexp(1.0, tileBits_);
  const std::array<std::int32_t, 3> corner = voxelIndex(tile);
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = static_cast<double>(corner[axis]) + kVoxelReach;
    const double gap = std::max({low - place[axis], place[axis] - (low + edge), 0.0});
    squared += gap * gap;
  }
  return squared > radius * radius;
}

void VoxelTiles::leaveBehind(const std::array<double, 3>& place, double radius) {
  if (tileBits_ == kVoxelKeyBits) return;
  ++calls_;
  for (auto& [tilePlace, tile] : tiles_) {
    if (!tile.blocks || tile.needed + kCallsToStay > calls_ || !isFar(tile.key, place, radius))
      continue;
    tile.blocks->save(bytes_);
    store_->store(tilePlace, bytes_);
    tile.sizeInStore = tile.blocks->size();
    givenUp_ += tile.blocks->bytes();
    tile.blocks.reset();
  }
  if (givenUp_ < kBytesToGiveBack) return;
  giveBackToSystem();
  givenUp_ = 0;
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
