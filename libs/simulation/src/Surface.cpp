// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include <array>

namespace toss::simulation {

const Reflection& reflectionOf(Material material) {
  static constexpr std::array<Reflection, 17> kReflections = {{
      {0.16, 0.0, 0.02},   // Asphalt
      {0.30, 0.0, 0.0},    // Concrete
      {0.40, 0.0, 0.0},    // Grass
      {0.25, 0.0, 0.0},    // Soil
      {0.50, 0.0, 0.0},    // Plaster
      {0.30, 0.0, 0.0},    // Brick
      {0.45, 0.0, 0.05},   // LightPaint
      {0.10, 0.0, 0.05},   // DarkPaint
      {0.10, 0.75, 0.10},  // Glass
      {0.06, 0.0, 0.0},    // Rubber
      {0.40, 0.0, 0.02},   // Metal
      {1.00, 0.0, 0.0},    // Retroreflector
      {0.25, 0.0, 0.0},    // Bark
      {0.45, 0.35, 0.0},   // Leaf
      {0.40, 0.60, 0.0},   // Wire
      {0.30, 0.0, 0.0},    // Cloth
      {0.40, 0.0, 0.0},    // Skin
  }};
  return kReflections[static_cast<std::size_t>(material)];
}

}  // namespace toss::simulation
