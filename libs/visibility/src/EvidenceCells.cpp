// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/EvidenceCells.h>

namespace toss {

std::vector<FreeSpaceSum> sumByInstance(const EvidenceCells& cells, std::int32_t instanceCount,
                                        int minFreeViews) {
  std::vector<FreeSpaceSum> sums(static_cast<std::size_t>(instanceCount) + 1);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    FreeSpaceSum& sum = sums[static_cast<std::size_t>(cells.instance[c])];
    ++sum.cells;
    if (isFree(cells, c, minFreeViews))
      ++sum.free;
    else if (isHit(cells, c))
      ++sum.hit;
    if (isGlimpsed(cells, c, minFreeViews)) ++sum.glimpsed;
  }
  return sums;
}

}  // namespace toss
