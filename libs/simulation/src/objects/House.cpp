// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "Structures.h"

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

constexpr std::uint16_t kLabel = semantics::kBuilding;
constexpr double kRecess = 0.15;

/// A piece of the front between x and x2, from z to z2, `y` behind the front.
void addPanel(Mesh& mesh, double x, double x2, double z, double z2, double y, Surface surface) {
  mesh.addQuad({x, y, z}, {x2, y, z}, {x2, y, z2}, {x, y, z2}, surface);
}

/// The four sides of an opening in the front.
void addReveal(Mesh& mesh, double x, double x2, double z, double z2, Surface surface) {
  for (double side : {x, x2}) {
    mesh.addQuad({side, 0, z}, {side, kRecess, z}, {side, kRecess, z2}, {side, 0, z2}, surface);
  }
  for (double level : {z, z2}) {
    mesh.addQuad({x, 0, level}, {x2, 0, level}, {x2, kRecess, level}, {x, kRecess, level}, surface);
  }
}

/// One storey of one bay: wall with a window (or a door) in it, and a dark room behind the glass.
void addBay(Mesh& mesh, double x, double x2, double z, double z2, bool door, Surface wall) {
  const double width = door ? 1.1 : std::min(1.4, 0.5 * (x2 - x));
  const double left = 0.5 * (x + x2 - width), right = left + width;
  const double sill = door ? z : z + 0.9, head = std::min(z2 - 0.3, z + 2.2);
  addPanel(mesh, x, left, z, z2, 0.0, wall);
  addPanel(mesh, right, x2, z, z2, 0.0, wall);
  addPanel(mesh, left, right, z, sill, 0.0, wall);
  addPanel(mesh, left, right, head, z2, 0.0, wall);
  addReveal(mesh, left, right, sill, head, wall);
  addPanel(mesh, left, right, sill, head, kRecess,
           {kLabel, door ? Material::DarkPaint : Material::Glass});
  addPanel(mesh, x, x2, z, z2, 3.0, {kLabel, Material::Plaster});
}

void addRoof(Mesh& mesh, double length, double depth, double height, Surface tiles) {
  constexpr double kOverhang = 0.5;
  const double ridge = height + 0.35 * depth;
  const Vector3d a(-kOverhang, -kOverhang, height - 0.2),
      b(length + kOverhang, -kOverhang, height - 0.2);
  const Vector3d c(length + kOverhang, 0.5 * depth, ridge), d(-kOverhang, 0.5 * depth, ridge);
  const Vector3d e(-kOverhang, depth + kOverhang, height - 0.2);
  const Vector3d f(length + kOverhang, depth + kOverhang, height - 0.2);
  mesh.addQuad(a, b, c, d, tiles);
  mesh.addQuad(d, c, f, e, tiles);
  mesh.addTriangle({0, 0, height}, {0, depth, height}, {0, 0.5 * depth, ridge}, tiles);
  mesh.addTriangle({length, 0, height}, {length, depth, height}, {length, 0.5 * depth, ridge},
                   tiles);
}

}  // namespace

Mesh makeHouse(RandomStream& random, double length, double depth, double height) {
  const Surface wall{kLabel, random.chance(0.5) ? Material::Plaster : Material::Brick};
  const int bays = std::max(1, static_cast<int>(length / 3.0));
  const int storeys = std::max(1, static_cast<int>(height / 2.8));
  const int doorBay = random.index(bays);
  Mesh mesh;
  for (int storey = 0; storey < storeys; ++storey) {
    const double z = storey == 0 ? -0.3 : height * storey / storeys;
    const double z2 = height * (storey + 1) / storeys;
    for (int bay = 0; bay < bays; ++bay) {
      const double x = length * bay / bays, x2 = length * (bay + 1) / bays;
      addBay(mesh, x, x2, z, z2, storey == 0 && bay == doorBay, wall);
      if (storey > 0 && random.chance(0.15)) {
        mesh.addBox({0.5 * (x + x2), -0.6, z + 0.05}, {x2 - x - 0.4, 1.2, 0.15}, wall);
        mesh.addBox({0.5 * (x + x2), -1.18, z + 0.6}, {x2 - x - 0.4, 0.04, 1.0},
                    {kLabel, Material::Wire});
      }
    }
  }
  for (double x : {0.0, length}) {
    mesh.addQuad({x, 0, -0.3}, {x, depth, -0.3}, {x, depth, height}, {x, 0, height}, wall);
  }
  addPanel(mesh, 0.0, length, -0.3, height, depth, wall);
  addRoof(mesh, length, depth, height, {kLabel, Material::Brick});
  return mesh;
}

}  // namespace toss::simulation
