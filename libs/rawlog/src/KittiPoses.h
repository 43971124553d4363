// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace toss {

/// Pose of the LiDAR (map <- LiDAR), the map being the LiDAR frame of the first pose's world:
/// Tr^-1 * P * Tr, where P is the row of poses.txt and Tr (camera <- LiDAR) that of calib.txt.
/// With Tr = identity the same bits as P.
Eigen::Isometry3d lidarPose(const Eigen::Isometry3d& cameraPose,
                            const Eigen::Isometry3d& cameraFromLidar);

/// The pose of a row of 12 numbers, the upper 3x4; none where the text is no such row or no rigid
/// motion.
std::optional<Eigen::Isometry3d> parseKittiPose(const std::string& text);

/// The reverse: a row with its line end, and one number, written so that reading them gives the
/// same bits.
std::string kittiRow(const Eigen::Isometry3d& pose);
std::string kittiNumber(double value);

/// Rows of 12 numbers, the upper 3x4 of each pose, shape [scans]. Throws UserError naming the line
/// that is no such row or no rigid motion.
std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file);

/// Tr of calib.txt (camera <- LiDAR), written "Tr:" or "Tr_velo_cam", "Tr_velo_to_cam". Throws
/// UserError if the file holds none, or one that is no rigid motion.
Eigen::Isometry3d readKittiCalibration(const std::filesystem::path& file);

/// One time per line [s], strictly ascending. Throws UserError naming the line that is not.
std::vector<double> readKittiTimes(const std::filesystem::path& file);

}  // namespace toss
