// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../Mesh.h"
#include "../Random.h"

namespace toss::simulation {

/// One leaf or clump of leaves: a triangle of about `size` [m] in a random attitude.
inline void addLeaf(Mesh& mesh, RandomStream& random, const Eigen::Vector3d& at, double size) {
  const auto offset = [&]() -> Eigen::Vector3d {
    return size * Eigen::Vector3d{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                  random.uniform(-1.0, 1.0)};
  };
  const Eigen::Vector3d a = at + offset(), b = at + offset(), c = at + offset();
  mesh.addTriangle(a, b, c, {semantics::kVegetation, Material::Leaf});
}

}  // namespace toss::simulation
