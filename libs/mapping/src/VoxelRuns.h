// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FixedChunk.h"

namespace toss {

/// Sums neighbouring returns of a scan that lie in one voxel and have one owner, chunk after chunk.
class VoxelRuns {
 public:
  /// Returns of one chunk.
  static constexpr std::size_t kChunk = FixedChunk::kMost;

  /// The runs of the returns at places [begin, begin + kChunk) as far as there are, of at most
  /// `most` returns each, in order of the scan; valid until the next call.
  RunSpan of(const VoxelReturns& returns, std::size_t begin, std::size_t most);
  /// Returns of the calls so far that are in no run because they are not finite or out of reach.
  std::size_t leftOut() const { return leftOut_; }

 private:
  void sumUp();
  std::size_t findStarts();

  FixedChunk chunk_;
  /// Sums of the words of all returns before each: what lies between two places is a difference.
  std::array<std::uint64_t, kChunk + 1> countAndOffsets_{}, intensity_{};
  /// Where stretches of returns of one voxel and owner begin, and where the last ends.
  std::array<std::size_t, kChunk + 1> starts_;
  std::array<VoxelRun, kChunk> runs_;
  std::size_t leftOut_ = 0;
};

}  // namespace toss
