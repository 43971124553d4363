// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/simulation/Simulator.h>

#include <cstdint>
#include <vector>

#include "Sweep.h"
#include "World.h"

namespace toss::simulation {

/// Knows the class of every instance over a log, and turns what the beams met into labels and
/// boxes.
class GroundTruth {
 public:
  /// An object that moves at any of `frames` times from 0 on, `period` [s] apart, counts as moving
  /// in all of them. The world must outlive this.
  GroundTruth(const World& world, double period, int frames);

  /// Takes over the returns of a revolution, ring by ring: points and labels.
  void collect(const SweepReturns& returns, const SensorModel& sensor, SimulatedScan& result);
  /// The objects with returns in the last revolution collected, as they are at `time` [s].
  void listBoxes(double time, std::vector<GroundTruthBox>& boxes) const;

 private:
  GroundTruthBox boxOfMover(std::size_t mover, double time) const;

  const World& world_;
  double period_;
  /// Whether each mover moves; class and returns by instance id.
  std::vector<bool> moves_;
  std::vector<std::uint16_t> labels_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace toss::simulation
