// SPDX-License-Identifier: BSD-3-Clause
#include <toss/visibility/EvidenceCells.h>

#include <cmath>

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

void silenceFloating(const NearbyGround& ground, float clearance, EvidenceCells& cells) {
  const auto floats = [&](std::size_t cell) {
    const float known = cells.heightAboveGround[cell];
    const float height =
        std::isnan(known) ? cells.z[cell] - ground.highest(cells.x[cell], cells.y[cell]) : known;
    return height > clearance;
  };
  const auto silence = [&](std::size_t cell) {
    for (Testimony* each : {&cells.past, &cells.later})
      each->freeViews[cell] = each->glimpseViews[cell] = 0;
  };
  std::vector<std::uint8_t> high(cells.size());
  for (std::size_t cell = 0; cell < high.size(); ++cell) high[cell] = floats(cell);
  for (std::size_t begin = 0, end; begin < cells.size(); begin = end) {
    const std::int32_t instance = cells.instance[begin];
    bool all = true;
    for (end = begin; end < cells.size() && cells.instance[end] == instance; ++end)
      all = all && high[end] != 0;
    for (std::size_t cell = begin; cell < end; ++cell)
      if (instance == 0 ? high[cell] != 0 : all) silence(cell);
  }
}

}  // namespace toss
