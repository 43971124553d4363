// SPDX-License-Identifier: BSD-3-Clause
#include "ScanThinning.h"

#include <toss/odometry/Downsampling.h>

namespace toss {

void takePoints(const PointCloud& cloud, const OdometryOptions& options,
                std::vector<Eigen::Vector3d>& points, std::vector<std::size_t>* index) {
  const double nearest = options.minRange * options.minRange;
  const double farthest = options.maxRange * options.maxRange;
  points.clear();
  if (index != nullptr) index->clear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d point(cloud.x[i], cloud.y[i], cloud.z[i]);
    const double squared = point.squaredNorm();
    // Not so for NaN either.
    if (!(squared > nearest && squared < farthest)) continue;
    points.push_back(point);
    if (index != nullptr) index->push_back(i);
  }
}

void thin(const std::vector<Eigen::Vector3d>& points, const OdometryOptions& options,
          std::vector<Eigen::Vector3d>& mapPoints, std::vector<Eigen::Vector3d>& sourcePoints) {
  constexpr double kMapThinning = 0.5, kSourceThinning = 1.5;
  const double size = options.effectiveVoxelSize();
  downsample(points, kMapThinning * size, mapPoints);
  downsample(mapPoints, kSourceThinning * size, sourcePoints);
}

}  // namespace toss
