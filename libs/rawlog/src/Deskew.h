// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PosedScan.h>

#include "RawlogPoses.h"

namespace toss {

/// Time of the latest return relative to the scan's time stamp [s]; 0 where there are no times.
float sweepEnd(const PointCloud& points);

/// Puts every return where the sensor would have seen it from its pose at the scan's time stamp:
/// p' = mapFromSensor(stamp)^-1 * mapFromSensor(stamp + time) * p. The path is sampled every
/// millisecond and taken as straight between samples (0.3 mm at 100 m and 5 rad/s). `stamp`: time
/// stamp of the scan [ticks]. False, and nothing is changed, where the scan has no times, is
/// compensated already, or has too few poses around it. Returns at the origin and those that are
/// not finite stay. `poseFromSensor`: where the sensor sits on what the poses are of; nullptr =
/// they are its own.
bool deskew(const RawlogPoses& poses, const Eigen::Isometry3d* poseFromSensor,
            PoseBuffer::Ticks stamp, PosedScan& scan);

}  // namespace toss
