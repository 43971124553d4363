// SPDX-License-Identifier: BSD-3-Clause
#include "Structures.h"

#include <algorithm>
#include <cmath>

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

constexpr Surface kPost{semantics::kPole, Material::Metal};
constexpr Surface kSheet{semantics::kTrafficSign, Material::Retroreflector};

}  // namespace

Mesh makeWall(double length, double height, double thickness) {
  Mesh mesh;
  mesh.addBox({0.5 * length, 0.0, 0.5 * height - 0.15}, {length, thickness, height + 0.3},
              {semantics::kBuilding, Material::Brick});
  return mesh;
}

Mesh makeFence(double length, double height) {
  const Surface wood{semantics::kFence, Material::Bark};
  Mesh mesh;
  const int posts = std::max(2, static_cast<int>(length / 2.0) + 1);
  for (int post = 0; post < posts; ++post) {
    const double x = length * post / (posts - 1);
    mesh.addBar({x, 0.0, -0.2}, {x, 0.0, height}, 0.05, 0.05, wood, 6);
  }
  for (double z : {0.4 * height, 0.95 * height}) {
    mesh.addBox({0.5 * length, 0.0, z}, {length, 0.04, 0.08}, wood);
  }
  mesh.addQuad({0, 0, 0.05}, {length, 0, 0.05}, {length, 0, 0.9 * height}, {0, 0, 0.9 * height},
               {semantics::kFence, Material::Wire});
  return mesh;
}

Mesh makeShelter() {
  const Surface metal{semantics::kOtherStructure, Material::Metal};
  const Surface glass{semantics::kOtherStructure, Material::Glass};
  Mesh mesh;
  mesh.addBox({0.0, 0.0, 2.55}, {4.2, 1.8, 0.1}, metal);
  for (double x : {-2.0, 2.0}) mesh.addBar({x, 0.8, -0.1}, {x, 0.8, 2.5}, 0.06, 0.06, metal, 6);
  mesh.addQuad({-2, 0.8, 0.2}, {2, 0.8, 0.2}, {2, 0.8, 2.2}, {-2, 0.8, 2.2}, glass);
  mesh.addQuad({-2, 0.8, 0.2}, {-2, -0.3, 0.2}, {-2, -0.3, 2.2}, {-2, 0.8, 2.2}, glass);
  mesh.addBox({0.0, 0.55, 0.45}, {3.0, 0.4, 0.06}, metal);
  return mesh;
}

Mesh makeBridge(double width, double span, double clearance) {
  const Surface concrete{semantics::kOtherStructure, Material::Concrete};
  Mesh mesh;
  mesh.addBox({0.0, 0.0, clearance + 0.5}, {width, span, 1.0}, concrete);
  for (double x : {-0.5 * width, 0.5 * width}) {
    mesh.addBox({x, 0.0, clearance + 1.5}, {0.15, span, 1.0}, concrete);
  }
  for (double y : {-0.5 * span, 0.5 * span}) {
    mesh.addBox({0.0, y, 0.5 * clearance}, {width, 1.0, clearance}, concrete);
  }
  return mesh;
}

Mesh makeLamp() {
  Mesh mesh;
  mesh.addBar({0, 0, -0.2}, {0, 0, 7.0}, 0.10, 0.06, kPost, 8);
  mesh.addBar({0, 0, 7.0}, {0, 1.8, 7.2}, 0.05, 0.04, kPost, 6);
  mesh.addBox({0, 2.0, 7.2}, {0.25, 0.7, 0.12}, kPost);
  return mesh;
}

Mesh makeSign() {
  Mesh mesh;
  mesh.addBar({0, 0, -0.2}, {0, 0, 2.9}, 0.035, 0.035, kPost, 6);
  mesh.addBox({-0.05, 0, 2.5}, {0.02, 0.65, 0.65}, kSheet);
  return mesh;
}

Mesh makeTrafficLight() {
  Mesh mesh;
  mesh.addBar({0, 0, -0.2}, {0, 0, 3.4}, 0.07, 0.07, kPost, 8);
  mesh.addBox({-0.15, 0, 2.9}, {0.2, 0.3, 0.95}, {semantics::kTrafficSign, Material::DarkPaint});
  return mesh;
}

Mesh makeBollard() {
  Mesh mesh;
  mesh.addBar({0, 0, -0.1}, {0, 0, 0.9}, 0.07, 0.07, kPost, 8);
  return mesh;
}

Mesh makeBench() {
  const Surface wood{semantics::kOtherObject, Material::Bark};
  Mesh mesh;
  mesh.addBox({0, 0, 0.45}, {1.8, 0.42, 0.05}, wood);
  mesh.addBox({0, 0.24, 0.72}, {1.8, 0.05, 0.35}, wood);
  for (double x : {-0.75, 0.75}) {
    mesh.addBox({x, 0.05, 0.2}, {0.07, 0.4, 0.5}, {semantics::kOtherObject, Material::Metal});
  }
  return mesh;
}

Mesh makeStairs(int steps, double rise, double run, double width) {
  const Surface stone{semantics::kOtherGround, Material::Concrete};
  const double half = 0.5 * width;
  Mesh mesh;
  for (int step = 0; step < steps; ++step) {
    const double x = step * run, z = step * rise;
    mesh.addQuad({x, -half, z}, {x, half, z}, {x, half, z + rise}, {x, -half, z + rise}, stone);
    mesh.addQuad({x, -half, z + rise}, {x, half, z + rise}, {x + run, half, z + rise},
                 {x + run, -half, z + rise}, stone);
  }
  return mesh;
}

Mesh makeGuardRail(double length) {
  const Surface metal{semantics::kFence, Material::Metal};
  Mesh mesh;
  mesh.addBox({0.5 * length, 0.0, 0.6}, {length, 0.08, 0.3}, metal);
  for (double x = 0.0; x <= length; x += 4.0) {
    mesh.addBox({x, 0.08, 0.3}, {0.1, 0.1, 0.8}, metal);
  }
  return mesh;
}

}  // namespace toss::simulation
