// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

#include <cstdint>

namespace toss {

/// One instance of one scan as the tracker sees it: b_G = box(S_G,k) of the paper.
struct Detection {
  /// Box around the instance's points, map frame.
  Box box;
  /// Number of the instance in its Segmentation, from 1.
  std::int32_t instance = 0;
  /// Returns in the instance.
  std::int32_t pointCount = 0;
  /// Too large to be an object that moves (spec section 3.4): never tracked, always static.
  bool background = false;
  /// Share of the instance's runs in the range image that end at something nearer, which hides the
  /// rest, on its left and on its right side seen from the sensor; 0 to 1, 0 where not measured
  /// (measureOcclusion). Both high: seen through an opening.
  float occludedLeft = 0.0f, occludedRight = 0.0f;
};

}  // namespace toss
