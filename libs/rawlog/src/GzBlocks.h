// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <vector>

namespace toss {

/// Compresses to gz, many blocks at a time and each on its own: as members of one file, which
/// readers of gz take for one. What is written does not depend on the number of threads.
class GzBlocks {
 public:
  /// `file`: where the members go; outlives this object. `level`: 1 compresses fastest, 12 best; 0
  /// stores the bytes as they are, with their checksum.
  GzBlocks(std::FILE* file, int level);
  ~GzBlocks();

  /// Takes bytes; false where they can not be compressed or written, with errno where it is known.
  bool write(const void* bytes, std::size_t count);
  /// Writes what is left; to be called once, at the end.
  bool finish();

 private:
  struct Block;
  bool writeBlocks(std::size_t count);

  std::FILE* file_;
  int level_;
  std::vector<std::unique_ptr<Block>> blocks_;
  /// Those that are full.
  std::size_t full_ = 0;
  bool written_ = false;
};

}  // namespace toss
