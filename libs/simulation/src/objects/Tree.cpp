// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "Leaves.h"
#include "Vegetation.h"

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

constexpr Surface kBark{semantics::kTrunk, Material::Bark};

}  // namespace

Mesh makeTree(RandomStream& random, double height, int leaves) {
  const double radius = 0.03 * height + 0.02;
  const double crown = 0.38 * height;
  const Vector3d fork(0.0, 0.0, 0.38 * height), middle(0.0, 0.0, 0.66 * height);
  Mesh mesh;
  mesh.addBar({0.0, 0.0, -0.3}, fork, 1.25 * radius, radius, kBark, 10);
  constexpr int kBoughs = 7;
  for (int bough = 0; bough < kBoughs; ++bough) {
    const double angle = 2.0 * M_PI * bough / kBoughs + random.uniform(-0.3, 0.3);
    const double reach = crown * random.uniform(0.4, 0.8);
    const Vector3d end(reach * std::cos(angle), reach * std::sin(angle),
                       height * random.uniform(0.55, 0.85));
    mesh.addBar(fork - Vector3d(0, 0, 0.1 * height * random.uniform(0, 1)), end, 0.45 * radius,
                0.02, kBark, 5);
    for (int leaf = 0; leaf < leaves / kBoughs; ++leaf) {
      const Vector3d spread{random.gaussian(0.0, 0.35 * crown), random.gaussian(0.0, 0.35 * crown),
                            random.gaussian(0.0, 0.12 * height)};
      addLeaf(mesh, random, 0.35 * middle + 0.65 * end + spread, 0.16);
    }
  }
  return mesh;
}

Mesh makeConifer(RandomStream& random, double height) {
  Mesh mesh;
  mesh.addBar({0.0, 0.0, -0.3}, {0.0, 0.0, height}, 0.02 * height + 0.03, 0.02, kBark, 8);
  const int leaves = static_cast<int>(220.0 * height);
  for (int leaf = 0; leaf < leaves; ++leaf) {
    const double share = std::sqrt(random.uniform(0.0, 1.0));
    const double radius = 0.25 * height * share * std::sqrt(random.uniform(0.1, 1.0));
    const double angle = random.uniform(0.0, 2.0 * M_PI);
    addLeaf(mesh, random,
            {radius * std::cos(angle), radius * std::sin(angle), height * (1.02 - 0.98 * share)},
            0.14);
  }
  return mesh;
}

}  // namespace toss::simulation
