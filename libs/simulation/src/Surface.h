// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace toss::simulation {

/// Classes of SemanticKITTI that the scenes use.
namespace semantics {
constexpr std::uint16_t kOutlier = 1, kCar = 10, kBicyclist = 31, kPerson = 30, kBus = 13,
                        kTruck = 18, kOtherVehicle = 20, kRoad = 40, kSidewalk = 48,
                        kOtherGround = 49, kBuilding = 50, kFence = 51, kOtherStructure = 52,
                        kVegetation = 70, kTrunk = 71, kTerrain = 72, kPole = 80, kTrafficSign = 81,
                        kOtherObject = 99;
constexpr std::uint16_t kMovingCar = 252, kMovingBicyclist = 253, kMovingPerson = 254,
                        kMovingBus = 257, kMovingTruck = 258, kMovingOther = 259;
}  // namespace semantics

enum class Material : std::uint8_t {
  Asphalt,
  Concrete,
  Grass,
  Soil,
  Plaster,
  Brick,
  LightPaint,
  DarkPaint,
  Glass,
  Rubber,
  Metal,
  Retroreflector,
  Bark,
  Leaf,
  Wire,
  Cloth,
  Skin
};

/// How a material answers a beam.
struct Reflection {
  /// Share of the light that comes back at normal incidence, 0 to 1.
  double reflectivity;
  /// Probability that a beam that meets it goes on (gaps between leaves, window panes).
  double transparency;
  /// Probability that a beam that meets it at a grazing angle is mirrored.
  double gloss;
};

const Reflection& reflectionOf(Material material);

/// What a triangle is.
struct Surface {
  std::uint16_t label;
  Material material;
};

}  // namespace toss::simulation
