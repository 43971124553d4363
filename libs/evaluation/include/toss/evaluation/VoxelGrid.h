// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/CellOrder.h>
#include <toss/evaluation/LabelledCloud.h>

namespace toss {

/// Voxelises as PCL's VoxelGrid does, with ERASOR's rule for labels (spec section 9.3): one point
/// per occupied voxel floor(p / voxelSize), at the centroid of its points; its label is that of the
/// nearest input point, in whatever voxel that lies, the lowest index where several are. Ordered as
/// PCL orders: x fastest, z slowest. (PCL leaves a cloud as it is where the voxels of its bounding
/// box exceed 2^31; this does not.)
LabelledCloud voxelize(const LabelledCloud& cloud, double voxelSize);

/// The same for points that are ordered already by cells of `voxelSize`; `label` is indexed as the
/// cloud behind `order`. `keys`, if given, receives the voxel of each point of the result.
void voxelize(const CellOrder& order, const std::vector<std::uint32_t>& label, double voxelSize,
              LabelledCloud& result, std::vector<CellKey>* keys = nullptr);

}  // namespace toss
