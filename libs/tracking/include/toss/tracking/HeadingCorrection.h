// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/Box.h>

namespace toss {

/// The yaw in [-pi/2, pi/2) that describes the same upright box.
double wrapYaw(double yaw);

/// The same box written with the yaw nearest to `yaw` [rad]: turned by half turns, and by quarter
/// turns with length and width exchanged (spec section 5.3). The result's yaw is not wrapped and
/// lies within pi/4 of `yaw`, so it can be averaged with it. Boxes with yaw 0 stay as they are
/// where `yaw` is 0.
Box alignedWithYaw(const Box& box, double yaw);

}  // namespace toss
