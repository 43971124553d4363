// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace toss {

/// Sensor labels in what is written, and of a KITTI folder's only sensor: the same for both, so
/// that a folder and the rawlog made of it give the same scans.
constexpr const char* kLidarLabel = "LIDAR";
constexpr const char* kPoseLabel = "POSE";

}  // namespace toss
