// SPDX-License-Identifier: BSD-3-Clause
#include "GzBlocks.h"

#include <libdeflate.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <new>

namespace toss {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 20, kBlocks = 8;

}  // namespace

struct GzBlocks::Block {
  explicit Block(int level)
      : compressor(libdeflate_alloc_compressor(level), &libdeflate_free_compressor) {
    if (!compressor) throw std::bad_alloc();
    compressed.resize(libdeflate_gzip_compress_bound(compressor.get(), kBlockBytes));
  }
  void compress() {
    compressedSize = libdeflate_gzip_compress(compressor.get(), bytes.data(), size,
                                              compressed.data(), compressed.size());
  }

  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor;
  std::vector<char> bytes = std::vector<char>(kBlockBytes), compressed;
  std::size_t size = 0, compressedSize = 0;
};

GzBlocks::GzBlocks(std::FILE* file, int level) : file_(file), level_(level) {}

GzBlocks::~GzBlocks() = default;

bool GzBlocks::write(const void* bytes, std::size_t count) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    if (full_ == blocks_.size()) blocks_.push_back(std::make_unique<Block>(level_));
    Block& block = *blocks_[full_];
    const std::size_t step = std::min(count, kBlockBytes - block.size);
    std::memcpy(block.bytes.data() + block.size, next, step);
    block.size += step;
    next += step;
    count -= step;
    if (block.size < kBlockBytes) return true;
    if (++full_ == kBlocks && !writeBlocks(kBlocks)) return false;
  }
  return true;
}

bool GzBlocks::writeBlocks(std::size_t count) {
  // Whoever waits for the blocks does not begin something else that may wait for this file.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t b) { blocks_[b]->compress(); });
  });
  for (std::size_t b = 0; b < count; ++b) {
    Block& block = *blocks_[b];
    if (block.compressedSize == 0 || std::fwrite(block.compressed.data(), 1, block.compressedSize,
                                                 file_) != block.compressedSize)
      return false;
    block.size = 0;
  }
  written_ = true;
  full_ = 0;
  return true;
}

bool GzBlocks::finish() {
  if (blocks_.empty()) blocks_.push_back(std::make_unique<Block>(level_));
  // A file of no bytes is one empty member.
  const bool rest = full_ < blocks_.size() && blocks_[full_]->size > 0;
  const std::size_t count = full_ + (rest || (full_ == 0 && !written_));
  return writeBlocks(count);
}

}  // namespace toss
