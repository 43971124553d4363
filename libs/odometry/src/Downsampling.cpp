// SPDX-License-Identifier: BSD-3-Clause
#include <toss/odometry/Downsampling.h>
#include <tsl/robin_set.h>

#include "KeyHash.h"

namespace toss {

VoxelKey voxelOf(const Eigen::Vector3d& point, double size) {
  const Eigen::Array3i index = (point.array() / size).floor().cast<int>();
  return voxelKey(index.x(), index.y(), index.z());
}

void downsample(const std::vector<Eigen::Vector3d>& points, double size,
                std::vector<Eigen::Vector3d>& result) {
  tsl::robin_set<VoxelKey, KeyHash> taken;
  taken.reserve(points.size() / 4);
  result.clear();
  for (const Eigen::Vector3d& point : points)
    if (taken.insert(voxelOf(point, size)).second) result.push_back(point);
}

}  // namespace toss
