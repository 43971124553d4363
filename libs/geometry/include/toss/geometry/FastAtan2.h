// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace toss {

/// atan2(y, x) [rad] in (-pi, pi], within 1e-5 rad of the exact value; 0 for (0, 0). Free of
/// branches, so that loops over points are vectorised, and built from single multiplications and
/// additions, so that every machine gives the same bits.
inline float fastAtan2(float y, float x) {
  constexpr float kPi = 3.14159265358979f;
  const float absX = std::fabs(x), absY = std::fabs(y);
  const float larger = absX > absY ? absX : absY;
  const float smaller = absX > absY ? absY : absX;
  const float ratio = smaller / (larger > 0.0f ? larger : 1.0f);
  const float s = ratio * ratio;
  // Minimax polynomial of atan on [0, 1].
  float angle =
      ((((-0.01172120f * s + 0.05265332f) * s - 0.11643287f) * s + 0.19354346f) * s - 0.33262347f) *
          s +
      0.99997726f;
  angle *= ratio;
  angle = absY > absX ? 0.5f * kPi - angle : angle;
  angle = x < 0.0f ? kPi - angle : angle;
  return y < 0.0f ? -angle : angle;
}

}  // namespace toss
