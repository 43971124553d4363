// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>

#include <filesystem>

namespace toss {

/// Reads a .bin of KITTI: float32 x y z intensity per return, all returns in their order, also
/// those that are not finite. Throws UserError if the file is missing or no multiple of 16 bytes.
void readKittiPoints(const std::filesystem::path& file, PointCloud& points);

/// Writes it; intensity 0 where the cloud has none. Throws UserError if it can't.
void writeKittiPoints(const std::filesystem::path& file, const PointCloud& points);

}  // namespace toss
