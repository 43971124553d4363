// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <vector>

#include "Vehicles.h"

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

/// Cross-section of the body at one place along the car: heights of window sill and roof [m], and
/// how far the roof's edge lies inwards as a share of the half width.
struct Station {
  double x, sill, roof, taper;
};

struct Shape {
  double length, width;
  std::vector<Station> stations;
};

Shape shapeOf(CarBody body) {
  switch (body) {
    case CarBody::Sedan:
      return {4.6,
              1.80,
              {{2.30, .45, .55, .9},
               {2.15, .62, .70, .9},
               {0.95, .88, .93, .9},
               {0.20, .92, 1.45, .72},
               {-1.00, .93, 1.44, .72},
               {-1.70, .93, 1.00, .88},
               {-2.20, .88, .98, .9},
               {-2.30, .50, .60, .9}}};
    case CarBody::Hatchback:
      return {3.9,
              1.72,
              {{1.95, .45, .55, .9},
               {1.82, .65, .75, .9},
               {0.95, .92, .97, .9},
               {0.30, .95, 1.50, .74},
               {-1.20, .96, 1.48, .74},
               {-1.80, .94, 1.00, .88},
               {-1.95, .50, .60, .9}}};
    case CarBody::Estate:
      return {4.7,
              1.82,
              {{2.35, .45, .55, .9},
               {2.20, .62, .72, .9},
               {1.00, .90, .95, .9},
               {0.25, .93, 1.48, .74},
               {-1.90, .94, 1.46, .76},
               {-2.25, .92, 1.00, .88},
               {-2.35, .50, .60, .9}}};
    case CarBody::Van:
      break;
  }
  return {5.3,
          1.95,
          {{2.65, .55, .70, .9},
           {2.50, .95, 1.05, .9},
           {1.95, 1.05, 1.20, .9},
           {1.40, 1.10, 2.05, .84},
           {-2.55, 1.12, 2.05, .86},
           {-2.65, .60, 2.00, .86}}};
}

constexpr double kClearance = 0.22;

/// Left half of a cross-section from the underside to the middle of the roof.
std::array<Vector3d, 4> outline(const Station& station, double halfWidth, double side) {
  return {Vector3d(station.x, side * 0.94 * halfWidth, kClearance),
          Vector3d(station.x, side * halfWidth, 0.5 * (kClearance + station.sill)),
          Vector3d(station.x, side * halfWidth, station.sill),
          Vector3d(station.x, side * station.taper * halfWidth, station.roof)};
}

/// Windows lie where the roof is well above the sill; windscreens where it rises or falls.
bool isCabin(const Station& station) {
  return station.roof - station.sill > 0.3;
}

void addSection(Mesh& mesh, const Station& a, const Station& b, double halfWidth, CarBody body,
                Surface paint) {
  const Surface glass{paint.label, Material::Glass};
  const bool cargo = body == CarBody::Van && a.x < 1.5;
  const bool window = (isCabin(a) || isCabin(b)) && !cargo;
  const bool screen = isCabin(a) != isCabin(b) && !(body == CarBody::Van && a.x < 0.0);
  for (double side : {-1.0, 1.0}) {
    const auto front = outline(a, halfWidth, side), back = outline(b, halfWidth, side);
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.addQuad(front[i], back[i], back[i + 1], front[i + 1], i == 2 && window ? glass : paint);
    }
  }
  const auto left = outline(a, halfWidth, 1.0), right = outline(a, halfWidth, -1.0);
  const auto leftBack = outline(b, halfWidth, 1.0), rightBack = outline(b, halfWidth, -1.0);
  mesh.addQuad(left[3], leftBack[3], rightBack[3], right[3], screen ? glass : paint);
  mesh.addQuad(left[0], leftBack[0], rightBack[0], right[0], paint);
}

void addEnd(Mesh& mesh, const Station& station, double halfWidth, Surface paint) {
  const auto left = outline(station, halfWidth, 1.0), right = outline(station, halfWidth, -1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    mesh.addQuad(left[i], left[i + 1], right[i + 1], right[i], paint);
  }
}

/// Wheels, seats behind the glass, number plates.
void addFittings(Mesh& mesh, const Shape& shape, std::uint16_t label) {
  const double half = 0.5 * shape.width;
  for (double x : {0.31 * shape.length, -0.31 * shape.length}) {
    for (double side : {-1.0, 1.0}) {
      mesh.addBar({x, side * (half - 0.2), 0.31}, {x, side * half, 0.31}, 0.31, 0.31,
                  {label, Material::Rubber}, 10);
    }
  }
  for (double x : {0.0, -0.9}) {
    for (double y : {-0.38, 0.38}) {
      mesh.addBox({x, y, 0.8}, {0.2, 0.5, 0.75}, {label, Material::Cloth});
    }
  }
  for (double x : {0.502, -0.502}) {
    mesh.addBox({x * shape.length, 0.0, 0.5}, {0.01, 0.5, 0.11}, {label, Material::Retroreflector});
  }
}

}  // namespace

Figure makeCar(CarBody body, Material paint) {
  const Shape shape = shapeOf(body);
  const double half = 0.5 * shape.width;
  const Surface surface{semantics::kCar, paint};
  Mesh mesh;
  for (std::size_t i = 0; i + 1 < shape.stations.size(); ++i) {
    addSection(mesh, shape.stations[i], shape.stations[i + 1], half, body, surface);
  }
  addEnd(mesh, shape.stations.front(), half, surface);
  addEnd(mesh, shape.stations.back(), half, surface);
  addFittings(mesh, shape, surface.label);

  Figure figure;
  figure.size = mesh.bounds().sizes();
  figure.size.z() = mesh.bounds().max().z();
  figure.parts = {std::move(mesh)};
  figure.stillLabel = semantics::kCar, figure.movingLabel = semantics::kMovingCar;
  return figure;
}

Figure makeCar(RandomStream& random) {
  static constexpr CarBody kBodies[] = {CarBody::Sedan, CarBody::Hatchback, CarBody::Estate,
                                        CarBody::Hatchback, CarBody::Van};
  const CarBody body = kBodies[random.index(5)];
  return makeCar(body, random.chance(0.35) ? Material::DarkPaint : Material::LightPaint);
}

Figure makeBoxCar(const Vector3d& size) {
  Figure figure;
  figure.parts.resize(1);
  figure.parts[0].addBox({0.0, 0.0, 0.5 * size.z()}, size, {semantics::kCar, Material::LightPaint});
  figure.size = size;
  figure.stillLabel = semantics::kCar, figure.movingLabel = semantics::kMovingCar;
  return figure;
}

Figure makeCarDoor(double openingTime) {
  constexpr double kLength = 1.05;
  Figure figure;
  figure.parts.resize(1);
  figure.parts[0].addBox({-0.5 * kLength, 0.0, 0.6}, {kLength, 0.06, 0.7},
                         {semantics::kOtherVehicle, Material::LightPaint});
  figure.articulation = [openingTime](std::size_t, double, double time) {
    const double share = std::min(1.0, std::max(0.0, time - openingTime));
    return planarPose(0.0, 0.0, 0.0, -1.1 * share);
  };
  figure.size = {kLength, 0.06, 0.95};
  figure.stillLabel = semantics::kCar, figure.movingLabel = semantics::kMovingOther;
  return figure;
}

}  // namespace toss::simulation
