// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/tracking/Association.h>

#include <cmath>
#include <random>

namespace toss {

/// Gates of the paper's method with Auto-MOS's numbers (spec section 5.5).
inline AssociationGates usualGates() {
  return {0.05, 0.7, 0.0};
}

/// A box of the size of a person or a car at a random place of a square of `side` [m].
inline Box randomBox(std::mt19937& random, double side) {
  std::uniform_real_distribution<double> place(0.0, side), unit(0.0, 1.0);
  Box box;
  box.center = {place(random), place(random), 0.2 * unit(random)};
  const bool isLarge = unit(random) < 0.5;
  box.length = isLarge ? 3.0 + unit(random) : 0.5 + 0.3 * unit(random);
  box.width = isLarge ? 1.7 + 0.3 * unit(random) : 0.5 + 0.3 * unit(random);
  box.height = 1.5 + 0.3 * unit(random);
  return box;
}

/// `targetCount` traces at that density, most of them seen again near by, some lost, some new.
inline AssociationProblem randomProblem(std::mt19937& random, int targetCount, double density) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> jitter(0.0, 0.15);
  const double side = std::sqrt(targetCount / density);
  AssociationProblem problem;
  problem.gates = usualGates();
  for (int i = 0; i < targetCount; ++i) {
    const Box box = randomBox(random, side);
    problem.targets.push_back({box, 2.0});
    if (unit(random) < 0.1) continue;
    Box seen = unit(random) < 0.05 ? randomBox(random, side) : box;
    seen.center += Eigen::Vector3d(jitter(random), jitter(random), jitter(random));
    seen.length *= 1.0 + 0.5 * jitter(random), seen.width *= 1.0 + 0.5 * jitter(random);
    problem.detections.push_back(seen);
  }
  return problem;
}

}  // namespace toss
