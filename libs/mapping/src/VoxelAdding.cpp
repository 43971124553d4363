// SPDX-License-Identifier: BSD-3-Clause
// Runs on their way into the blocks: passes over many of them, with as few branches that can not be
// foretold as may be, so that the memory answers many questions at a time.
#include <toss/geometry/ProcessorVariants.h>

#include "VoxelBlocks.h"

namespace toss {

/// Runs that are added together: stretches of them that follow each other in one block.
struct VoxelBlocks::Batch {
  struct Stretch {
    VoxelKey key;
    std::uint64_t hash;
    /// Voxels of the runs, by place in the block.
    std::uint64_t voxels;
    Block* block;
    /// As they are in the block once it has records of all these voxels.
    std::uint64_t mask;
    VoxelRecord* records;
  };

  const VoxelRun* runs;
  std::size_t runCount;
  /// Of each run.
  std::array<std::uint8_t, kBatch> stretchOf;
  /// The first is none.
  std::array<Stretch, kBatch + 1> stretches;
  std::size_t end = 0;
  /// Those that bring new voxels.
  std::array<std::uint8_t, kBatch> bringing;
  std::size_t bringingCount = 0;
};

TOSS_ALSO_FOR_AVX2
void VoxelBlocks::add(const VoxelRun* first, const VoxelRun* last) {
  static_assert(kBatch < 256, "stretches are numbered in bytes");
  makeRoom();
  Batch batch;
  batch.runs = first;
  batch.runCount = static_cast<std::size_t>(last - first);
  findStretches(batch);
  findBlocks(batch);
  makeRecords(batch);
  for (std::size_t i = 0; i < batch.runCount; ++i) {
    const VoxelRun& run = first[i];
    const Batch::Stretch& stretch = batch.stretches[batch.stretchOf[i]];
    VoxelRecord& record = stretch.records[countBits(stretch.mask & (bitOf(run.key) - 1))];
    if (record.takes(run))
      record.add(run);
    else
      addLarge(record, run);
  }
}

inline void VoxelBlocks::findStretches(Batch& batch) const {
  VoxelKey block = kNone;
  std::uint64_t voxels = 0;
  std::size_t stretch = 0;
  for (std::size_t i = 0; i < batch.runCount; ++i) {
    const VoxelKey key = batch.runs[i].key;
    const bool begins = cubeOf(key, kBlockBits) != block;
    block = cubeOf(key, kBlockBits);
    stretch += begins;
    voxels = (voxels & (std::uint64_t{begins} - 1)) | bitOf(key);
    batch.stretchOf[i] = static_cast<std::uint8_t>(stretch);
    batch.stretches[stretch].key = block;
    batch.stretches[stretch].voxels = voxels;
  }
  batch.end = stretch + 1;
  for (std::size_t s = 1; s < batch.end; ++s) {
    batch.stretches[s].hash = hash(batch.stretches[s].key);
    prefetch(batch.stretches[s].hash);
  }
}

inline void VoxelBlocks::findBlocks(Batch& batch) {
  for (std::size_t s = 1; s < batch.end; ++s) {
    Batch::Stretch& stretch = batch.stretches[s];
    stretch.block = &findOrMake(stretch.key, stretch.hash);
    const Block block = *stretch.block;
    const std::uint64_t voxels = stretch.voxels;
    __builtin_prefetch(block.records + countBits(block.mask & ((voxels & -voxels) - 1)), 1);
    __builtin_prefetch(
        block.records + countBits(block.mask & (~std::uint64_t{0} >> __builtin_clzll(voxels))), 1);
    batch.bringing[batch.bringingCount] = static_cast<std::uint8_t>(s);
    batch.bringingCount += (voxels & ~block.mask) != 0;
  }
}

inline void VoxelBlocks::makeRecords(Batch& batch) {
  // New records may move all the others.
  for (std::size_t i = 0; i < batch.bringingCount; ++i) {
    const Block& block = *batch.stretches[batch.bringing[i]].block;
    constexpr std::uint32_t kStep = RecordPool::kInLine;
    for (std::uint32_t r = 0; r < countBits(block.mask) + kStep; r += kStep)
      __builtin_prefetch(block.records + r, 1);
  }
  for (std::size_t i = 0; i < batch.bringingCount; ++i) {
    const Batch::Stretch& stretch = batch.stretches[batch.bringing[i]];
    // A stretch before may have brought them.
    if (const std::uint64_t added = stretch.voxels & ~stretch.block->mask)
      insert(*stretch.block, added);
  }
  for (std::size_t s = 1; s < batch.end; ++s) {
    batch.stretches[s].mask = batch.stretches[s].block->mask;
    batch.stretches[s].records = batch.stretches[s].block->records;
  }
}

}  // namespace toss
