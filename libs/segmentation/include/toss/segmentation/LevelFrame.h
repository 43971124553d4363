// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>

namespace toss {

/// Turns a scan into the level frame: the whole rotation of `mapFromSensor` and no translation, so
/// that heights are along gravity whatever the robot's roll and pitch (spec section 2.8). `points`:
/// sensor frame [m]; `level`: axes of the map, origin at the sensor [m], shape [n], NaN where a
/// coordinate is not finite.
void toLevelFrame(const PointCloud& points, const Eigen::Isometry3d& mapFromSensor,
                  LevelPoints& level);

}  // namespace toss
