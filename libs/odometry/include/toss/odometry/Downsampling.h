// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelKey.h>

#include <Eigen/Core>
#include <vector>

namespace toss {

/// The voxel that a point [m] lies in, edge `size` [m]; coordinates reach 2^20 voxels each way.
VoxelKey voxelOf(const Eigen::Vector3d& point, double size);

/// The first point of each voxel, in the order of `points` (KISS-ICP, section III-B). `size`: edge
/// of the voxels [m]. Replaces `result`.
void downsample(const std::vector<Eigen::Vector3d>& points, double size,
                std::vector<Eigen::Vector3d>& result);

}  // namespace toss
