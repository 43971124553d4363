// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "Leaves.h"
#include "Vegetation.h"

namespace toss::simulation {

using Eigen::Vector3d;

Mesh makeHedge(RandomStream& random, double length, double width, double height) {
  Mesh mesh;
  const int leaves = static_cast<int>(length * 260.0 * height);
  for (int leaf = 0; leaf < leaves; ++leaf) {
    const double x = random.uniform(0.0, length);
    const double top = height * (1.0 + 0.06 * std::sin(1.7 * x) + 0.04 * std::sin(4.1 * x));
    const double z = top * std::sqrt(random.uniform(0.0, 1.0));
    addLeaf(mesh, random, {x, random.uniform(-0.5, 0.5) * width, z}, 0.07);
  }
  const int stems = std::max(1, static_cast<int>(length / 0.6));
  for (int stem = 0; stem < stems; ++stem) {
    const double x = length * (stem + 0.5) / stems;
    mesh.addBar({x, 0.0, -0.1}, {x + random.uniform(-0.2, 0.2), 0.0, 0.8 * height}, 0.03, 0.01,
                {semantics::kVegetation, Material::Bark}, 5);
  }
  return mesh;
}

Mesh makeBush(RandomStream& random, double radius, double height) {
  Mesh mesh;
  const int leaves = static_cast<int>(500.0 * radius * radius * height) + 60;
  for (int leaf = 0; leaf < leaves; ++leaf) {
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    const double share = std::sqrt(random.uniform(0.05, 1.0));
    const double z = height * random.uniform(0.02, 1.0);
    const double bulge = std::sqrt(std::max(0.05, 1.0 - std::pow(z / height, 2.0)));
    addLeaf(mesh, random,
            {radius * share * bulge * std::cos(angle), radius * share * bulge * std::sin(angle), z},
            0.08);
  }
  return mesh;
}

Mesh makeAnyBush(RandomStream& random, double maxRadius, double maxHeight) {
  const double radius = maxRadius * random.uniform(0.4, 1.0);
  return makeBush(random, radius, maxHeight * random.uniform(0.35, 1.0));
}

Mesh makeTallGrass(RandomStream& random, double radius, int tufts) {
  Mesh mesh;
  for (int tuft = 0; tuft < tufts; ++tuft) {
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    const double far = radius * std::sqrt(random.uniform(0.0, 1.0));
    const Vector3d root(far * std::cos(angle), far * std::sin(angle), -0.05);
    for (int blade = 0; blade < 5; ++blade) {
      const Vector3d tip = root + Vector3d{random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15),
                                           random.uniform(0.2, 0.55)};
      mesh.addTriangle(root, root + Vector3d(0.03, 0.02, 0.0), tip,
                       {semantics::kVegetation, Material::Leaf});
    }
  }
  return mesh;
}

}  // namespace toss::simulation
