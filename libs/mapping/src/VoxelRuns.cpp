// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelRuns.h"

#include <algorithm>

namespace toss {

void VoxelRuns::sumUp() {
  std::uint64_t countAndOffsets = 0, intensity = 0;
  for (std::size_t i = 0; i < chunk_.count; ++i) {
    countAndOffsets_[i + 1] = countAndOffsets += chunk_.countAndOffsets[i];
    intensity_[i + 1] = intensity += chunk_.intensity[i];
  }
}

std::size_t VoxelRuns::findStarts() {
  // Where a stretch begins is hard to foresee: every place is written, and kept where one does.
  std::size_t stretches = 0;
  for (std::size_t i = 0; i < chunk_.count; ++i) {
    starts_[stretches] = i;
    stretches += chunk_.change[i] != 0;
  }
  starts_[stretches] = chunk_.count;
  return stretches;
}

RunSpan VoxelRuns::of(const VoxelReturns& returns, std::size_t begin, std::size_t most) {
  chunk_.fill(returns, begin);
  leftOut_ += chunk_.leftOut;
  sumUp();
  const std::size_t stretches = findStarts();
  VoxelRun* run = runs_.data();
  for (std::size_t stretch = 0; stretch < stretches; ++stretch) {
    std::size_t first = starts_[stretch];
    const std::size_t end = starts_[stretch + 1];
    if (chunk_.key[first] == FixedChunk::kNoVoxel) continue;
    for (std::size_t last; first < end; first = last) {
      last = std::min(first + most, end);
      *run++ = {chunk_.key[first], countAndOffsets_[last] - countAndOffsets_[first],
                chunk_.owner[first] | (intensity_[last] - intensity_[first])};
    }
  }
  return {runs_.data(), run};
}

}  // namespace toss
