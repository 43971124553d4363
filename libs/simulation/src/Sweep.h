// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/SensorModel.h>

#include <cstdint>
#include <vector>

#include "Beam.h"
#include "RayCaster.h"
#include "World.h"

namespace toss::simulation {

/// How a revolution is made.
struct SweepSettings {
  /// Duration of a revolution [s].
  double period = 0.1;
  bool compensated = true;
  bool noise = true;
};

/// What all beams of one revolution gave, beam after beam from the top, azimuth growing from 0 to
/// 2 pi, shape [rows * columns]; range 0 where nothing came back.
struct SweepReturns {
  std::vector<BeamReturn> beams;
  /// Coordinates in the sensor frame [m], shape as beams.
  std::vector<Eigen::Vector3f> points;
};

/// Time at which a column is measured, relative to the time stamp [s]. The sweep begins at the
/// rear and runs clockwise.
double columnTime(int column, int columns, double period);

/// Makes the revolution around time `stamp` [s]. `key`: random key of the scan. Runs on as many
/// threads as the caller's arena has, with the same result for any number.
void sweep(const World& world, RayCaster& caster, const SensorModel& sensor,
           const SweepSettings& settings, double stamp, std::uint64_t key, SweepReturns& result);

}  // namespace toss::simulation
