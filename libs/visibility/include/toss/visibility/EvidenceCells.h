// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/NearbyGround.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace toss {

/// What a number of views say about cells.
struct Testimony {
  /// Views that saw through each cell, views that measured it, and views of which some ray went
  /// past it without any measuring it, as through a bush, shape [cells].
  std::vector<std::uint8_t> freeViews, hitViews, glimpseViews;

  void reset(std::size_t cells) {
    freeViews.assign(cells, 0);
    hitViews.assign(cells, 0);
    glimpseViews.assign(cells, 0);
  }
  /// Enough views saw through the cell, and more than measured it.
  bool isFree(std::size_t cell, int minFreeViews) const {
    return freeViews[cell] >= minFreeViews && freeViews[cell] > hitViews[cell];
  }
  /// Enough views went past the cell, and far more than measured it.
  bool isGlimpsed(std::size_t cell, int minFreeViews) const {
    return glimpseViews[cell] >= minFreeViews && glimpseViews[cell] > 3 * hitViews[cell];
  }
};

/// The returns of one scan that stand above ground, thinned to one per cell and instance, with what
/// the views of other scans say about each; instance by instance, the unclustered ones first.
struct EvidenceCells {
  /// Level frame of the scan [m], shape [cells].
  std::vector<float> x, y, z;
  /// Height over the ground [m], NaN where it is not known, shape [cells].
  std::vector<float> heightAboveGround;
  /// Instance of each cell, 0 = unclustered, shape [cells].
  std::vector<std::int32_t> instance;
  /// Testimony of the views taken before and after the scan.
  Testimony past, later;
  /// Unclustered points of the scan, ascending, and the cell of each, shape [unclustered].
  std::vector<std::int32_t> lonePoint, loneCell;

  std::size_t size() const { return x.size(); }
};

/// Whether a cell counts as seen through: before the scan (what is there has arrived), or after it
/// (it has left). Asked together, an object that stands half of the time would be free in half of
/// the views and hit in the others, as foliage is all the time.
inline bool isFree(const EvidenceCells& cells, std::size_t cell, int minFreeViews) {
  return cells.past.isFree(cell, minFreeViews) || cells.later.isFree(cell, minFreeViews);
}

/// The same for glimpses past the cell: weak evidence, for foliage is glimpsed past as well.
inline bool isGlimpsed(const EvidenceCells& cells, std::size_t cell, int minFreeViews) {
  return cells.past.isGlimpsed(cell, minFreeViews) || cells.later.isGlimpsed(cell, minFreeViews);
}

inline bool isHit(const EvidenceCells& cells, std::size_t cell) {
  return cells.past.hitViews[cell] > 0 || cells.later.hitViews[cell] > 0;
}

/// What views say about a set of cells together.
struct FreeSpaceSum {
  /// Cells in all; cells seen through; cells measured again and not seen through. The others are
  /// hidden from all views, or lie where no view has returns.
  int cells = 0, free = 0, hit = 0;
  /// Cells glimpsed past, the free ones included.
  int glimpsed = 0;

  void add(const FreeSpaceSum& other) {
    cells += other.cells, free += other.free, hit += other.hit, glimpsed += other.glimpsed;
  }
  /// Shares of the cells that views say something about; 0 where they say nothing.
  double freeShare() const {
    return free + hit > 0 ? static_cast<double>(free) / (free + hit) : 0.0;
  }
  /// Share of all cells.
  double hitShare() const { return cells > 0 ? static_cast<double>(hit) / cells : 0.0; }
  double glimpsedShare() const { return cells > 0 ? static_cast<double>(glimpsed) / cells : 0.0; }
};

/// Sums of each instance, shape [instanceCount + 1]; entry 0 holds the unclustered cells.
std::vector<FreeSpaceSum> sumByInstance(const EvidenceCells& cells, std::int32_t instanceCount,
                                        int minFreeViews);

/// Takes back that views saw through and past lone returns and whole instances that are more than
/// `clearance` [m] above the ground, as far as it is known by now: twigs, mostly.
void silenceFloating(const NearbyGround& ground, float clearance, EvidenceCells& cells);

}  // namespace toss
