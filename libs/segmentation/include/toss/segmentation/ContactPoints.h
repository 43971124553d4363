// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/GroundOptions.h>
#include <toss/segmentation/RangeImage.h>
#include <toss/segmentation/Segmentation.h>

namespace toss {

/// Gives feet, tyres and bumpers back to the objects that they belong to (our addition: the lowest
/// decimetre of movers is the largest loss of ground segmentation, spec section 11.1). A Ground
/// return that is higher than `contact_height` becomes Unclustered again where one of the beams
/// right above it meets something that stands on it: not ground itself, and joined to it by a line
/// steeper than `contact_slope`. Ground in front of an object is never joined so steeply, as beams
/// meet it nearer by.
void releaseContactPoints(const LevelPoints& points, const RangeImage& image,
                          const GroundOptions& options, Segmentation& segmentation);

}  // namespace toss
