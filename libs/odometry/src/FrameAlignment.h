// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace toss {

/// One motion as poses tell it (frame of the poses) and as the scans do (LiDAR frame).
struct MotionPair {
  Eigen::Isometry3d given, found;
};

/// How far a motion takes a point 10 m away [m]: its translation and 10 m times its angle.
double reach(const Eigen::Isometry3d& motion);

/// camera <- LiDAR of a camera that looks along the LiDAR's x: z ahead, x right, y down.
Eigen::Isometry3d cameraAxesFromLidar();

/// frame of the poses <- LiDAR, where both sit on the same body: X of given X = X found for all
/// pairs, the rotation from the axes of the motions, the shift by least squares from turns (0 where
/// there are none).
Eigen::Isometry3d poseFrameFromSensor(const std::vector<MotionPair>& pairs);

}  // namespace toss
