// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <Eigen/Geometry>

namespace mrpt::poses {
class CPose3D;
}

namespace toss {

/// The same matrix, bit for bit, in MRPT's type. Rawlogs keep it as it is.
mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& pose);
Eigen::Isometry3d fromMrpt(const mrpt::poses::CPose3D& pose);

/// MRPT's time stamp nearest to `seconds` of UNIX time [s]; its unit is 100 ns. Unlike
/// mrpt::Clock::fromDouble it does not lose the last microseconds.
mrpt::Clock::time_point toMrptTime(double seconds);
/// UNIX time [s] of a time stamp: toMrptTime() gives back the same seconds from it.
double fromMrptTime(mrpt::Clock::time_point time);

/// Whether the matrix is finite and its rotation is one, to within 1e-3.
bool isRigid(const Eigen::Isometry3d& pose);

}  // namespace toss
