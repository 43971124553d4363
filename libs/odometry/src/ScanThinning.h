// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/odometry/OdometryOptions.h>

#include <Eigen/Core>
#include <vector>

namespace toss {

/// The returns in range [m, sensor frame], in their order. With `index`, their numbers in the cloud
/// too.
void takePoints(const PointCloud& cloud, const OdometryOptions& options,
                std::vector<Eigen::Vector3d>& points, std::vector<std::size_t>* index = nullptr);

/// Thins a scan twice: to half of the map's voxels for the map, and to 1.5 times of them for the
/// alignment (KISS-ICP, section III-B).
void thin(const std::vector<Eigen::Vector3d>& points, const OdometryOptions& options,
          std::vector<Eigen::Vector3d>& mapPoints, std::vector<Eigen::Vector3d>& sourcePoints);

}  // namespace toss
