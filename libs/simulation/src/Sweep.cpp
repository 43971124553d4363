// SPDX-License-Identifier: BSD-3-Clause
#include "Sweep.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "Random.h"

namespace toss::simulation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

double columnAzimuth(int column, int columns) {
  return 2.0 * M_PI * (column + 0.5) / columns;
}

/// Measures all beams of one column.
void sweepColumn(const World& world, const Beam& beam, const SensorModel& sensor,
                 const SweepSettings& settings, double stamp, const Isometry3d& stampFromMap,
                 std::uint64_t key, int column, SweepReturns& result) {
  const double time = columnTime(column, sensor.columns, settings.period);
  const Isometry3d mapFromSensor = world.mapFromSensor(stamp + time);
  const double azimuth = columnAzimuth(column, sensor.columns);
  for (int row = 0; row < sensor.rows(); ++row) {
    const double elevation = static_cast<double>(sensor.elevations[static_cast<std::size_t>(row)]);
    const Vector3d ahead(std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    const auto index = static_cast<std::size_t>(row * sensor.columns + column);
    const Vector3d direction = mapFromSensor.linear() * ahead;
    const BeamReturn measured = beam.measure(mapFromSensor.translation(), direction,
                                             time / settings.period + 0.5, hash(key, index));
    const Vector3d raw = measured.range * ahead;
    result.beams[index] = measured;
    result.points[index] =
        (settings.compensated ? Vector3d(stampFromMap * (mapFromSensor * raw)) : raw).cast<float>();
  }
}

}  // namespace

double columnTime(int column, int columns, double period) {
  const double turns = (column + 0.5) / columns;
  return -period * (turns < 0.5 ? turns : turns - 1.0);
}

void sweep(const World& world, RayCaster& caster, const SensorModel& sensor,
           const SweepSettings& settings, double stamp, std::uint64_t key, SweepReturns& result) {
  const auto count = static_cast<std::size_t>(sensor.rows() * sensor.columns);
  result.beams.resize(count);
  result.points.resize(count);
  caster.setSweep(stamp - 0.5 * settings.period, stamp + 0.5 * settings.period);

  const Beam beam(caster, sensor, settings.noise);
  const Isometry3d stampFromMap = world.mapFromSensor(stamp).inverse();
  tbb::parallel_for(tbb::blocked_range<int>(0, sensor.columns, 32), [&](const auto& columns) {
    for (int column = columns.begin(); column < columns.end(); ++column) {
      sweepColumn(world, beam, sensor, settings, stamp, stampFromMap, key, column, result);
    }
  });
}

}  // namespace toss::simulation
