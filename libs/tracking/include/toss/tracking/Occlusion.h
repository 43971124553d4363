// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>
#include <toss/tracking/Detection.h>

#include <vector>

namespace toss {

/// Finds where the view of an instance ends because something nearer hides the rest: fills
/// Detection::occludedLeft and occludedRight of `detections`, which lie in order of their instances
/// (spec section 3.5, "partially occluded"). A part of a wall that is seen through a window or
/// between two cars wanders as the sensor passes by, although nothing moves.
void measureOcclusion(const RangeImage& image, const Segmentation& segmentation,
                      std::vector<Detection>& detections);

}  // namespace toss
