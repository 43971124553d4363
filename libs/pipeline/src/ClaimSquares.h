// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <vector>

#include "ClaimFootprint.h"
#include "ClaimGrid.h"
#include "ClaimReturns.h"

namespace toss {

/// Picks the returns that boxes may claim in one pass over the scan, by small squares of the ground
/// plane, so that only few have to be looked at closely.
class ClaimSquares {
 public:
  /// What a box may claim besides returns in no instance, where its footprint lies.
  struct Reach {
    /// Growth of the footprint to its sides [m].
    float margin = 0.0f;
    /// Whether it may claim returns out of instances but its own, and low ground.
    bool cuts = false, residue = false;
    /// Its own instance, 0 = none.
    std::int32_t instance = 0;
  };

  /// Forgets all boxes.
  void clear();
  void mark(const ClaimFootprint& footprint, const Reach& reach);

  /// Replaces `found` by all returns that marked boxes may claim, and others near them. Ground up
  /// to `lowGround` [m] over the ground is residue at most; only instances that are `cuttable` are
  /// cut, shape [instanceCount + 1].
  void find(const LevelPoints& points, const Segmentation& segmentation, float lowGround,
            const std::vector<bool>& cuttable, ClaimReturns& found);

 private:
  /// The lowest bits tell what may be claimed outside instances; above them stands the instance
  /// whose box cuts, 0 for none and kMany for several or one without an instance.
  using Mark = std::uint16_t;
  struct Block;
  void findInBlock(const LevelPoints& points, const Segmentation& segmentation, float lowGround,
                   std::size_t begin, std::size_t size, ClaimReturns& found) const;
  static void findStretches(ClaimReturns& found);
  void findOwnMarks(const std::vector<bool>& cuttable);

  /// Shape [kSquares * kSquares], by x and then y.
  std::vector<Mark> marks_;
  /// Mark that the box of each instance leaves.
  std::vector<Mark> ownMark_;
};

}  // namespace toss
