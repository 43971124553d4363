// SPDX-License-Identifier: BSD-3-Clause
#include "SweepTimes.h"

#include <cmath>

namespace toss {

void setSweepTimes(const InputOptions& options, PointCloud& points) {
  constexpr double kDegrees = 180.0 / M_PI;
  const double sense = options.sweepSense == SweepSense::Clockwise ? -1.0 : 1.0;
  points.time.assign(points.size(), 0.0f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x[i], y = points.y[i];
    if (!std::isfinite(x + y) || (x == 0.0 && y == 0.0)) continue;
    const double turns = sense * (kDegrees * std::atan2(y, x) - options.sweepStart) / 360.0;
    const double share = turns - std::floor(turns);
    points.time[i] = static_cast<float>((share - options.sweepStamp) / options.sweepRate);
  }
}

}  // namespace toss
