// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/PointCloud.h>
#include <toss/rawlog/InputOptions.h>

namespace toss {

/// Gives each return the time at which a LiDAR that turns as `options` say (sweepRate, sweepSense,
/// sweepStart, sweepStamp) looks into its azimuth, relative to the scan's time stamp [s]:
/// (turned / 360 - sweepStamp) / sweepRate, with `turned` [degrees] in [0, 360) from the start in
/// the sense of rotation. Returns without an azimuth get 0.
void setSweepTimes(const InputOptions& options, PointCloud& points);

}  // namespace toss
