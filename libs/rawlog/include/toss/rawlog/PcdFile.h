// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/VoxelMap.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <vector>

namespace toss {

/// A PCD file that holds one scan.
struct PcdScan {
  /// Its points, relative to `offset` [m]; those that are not finite are left out.
  std::vector<MapPoint> points;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  /// Its line VIEWPOINT [m], not applied to the points; none where the header has no such line.
  std::optional<Eigen::Isometry3d> viewpoint;
};

/// Reads a PCD (ascii, binary or binary_compressed). Intensity is found as readPointCloudFile()
/// does (PlyFile.h). Throws UserError naming file and place for anything damaged or no PCD.
PcdScan readPcdScan(const std::filesystem::path& file);

}  // namespace toss
