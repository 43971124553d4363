// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Gives feet, tyres and bumpers back to the objects that they belong to (our addition: the lowest
/// decimetre of movers is the largest loss of ground segmentation, spec section 11.1). A Ground
/// return that is higher than `contact_height` becomes Unclustered again where one of the beams
/// right above it meets something that stands on it: not ground itself, and joined to it by a line
/// steeper than `contact_slope`. Ground in front of an object is never joined so steeply, as beams
/// meet it nearer by. Keeps its buffers from scan to scan.
class ContactPoints {
 public:
  void release(const LevelPoints& points, const RangeImage& image, const GroundOptions& options,
               Segmentation& segmentation);

 private:
  void findCandidates(const Segmentation& segmentation, float height);
  void sortByRow(const RangeImage& image);

  /// Ground returns that are high enough, in the order of the scan; only grows, the first `count_`
  /// are those.
  std::vector<std::int32_t> found_;
  std::size_t count_ = 0;
  /// The same by row from the top, and in the order of the scan within a row.
  std::vector<std::int32_t> sorted_, rowBegin_;
};

}  // namespace toss
