// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>
#include <toss/tracking/BoxOptions.h>
#include <toss/tracking/Detection.h>

#include <Eigen/Core>
#include <vector>

namespace toss {

/// Boxes of the instances of a scan: b_G,k = box(S_G,k) of the paper, one per instance, in order of
/// the instances' numbers (spec section 4). Box coordinates are exact to the float precision of
/// the level frame however far from the map's origin the sensor is; extents may be 0.
/// `sensorPosition`: origin of the level frame in the map [m]. `result` is overwritten.
/// Throws UserError for options out of range.
void detectInstances(const LevelPoints& points, const Segmentation& segmentation,
                     const Eigen::Vector3d& sensorPosition, const BoxOptions& options,
                     std::vector<Detection>& result);

}  // namespace toss
