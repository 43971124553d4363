// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace toss {

/// Colour of a point, a line or a swatch, sRGB.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// Colours along a scale.
enum class Ramp {
  Turbo,    ///< blue over green and yellow to red: heights
  Viridis,  ///< violet over green to yellow: intensities
  Gray      ///< dark to light, leaves the hues to what is marked
};

/// The colour at `position` of the ramp, clamped to [0, 1]. The ends are cut so that no colour of a
/// ramp vanishes in a dark or a light background.
Color rampColor(Ramp ramp, double position);

/// A colour for the trace of that number: neighbouring numbers differ clearly. Never a red or grey,
/// which mark removed and static points.
Color trackColor(std::uint64_t track);

}  // namespace toss
