// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace toss {

/// atan2(y, x) [rad] in single precision without branches, so that a loop over it is vectorised.
/// Polynomial of degree 15 (Abramowitz and Stegun, 4.4.49); off by less than 1e-6 rad everywhere.
/// (0, 0) gives 0 or pi by the sign of x; NaN gives NaN. Built from single multiplications and
/// additions: every machine gives the same bits.
inline float fastAtan2(float y, float x) {
  constexpr float kPi = 3.14159265358979f;
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float larger = std::max(ax, ay), smaller = std::min(ax, ay);
  const float a = smaller / std::max(larger, 1e-30f);
  const float s = a * a;
  float p = -0.0040540580f;
  p = p * s + 0.0218612288f;
  p = p * s - 0.0559098861f;
  p = p * s + 0.0964200441f;
  p = p * s - 0.1390853351f;
  p = p * s + 0.1994653599f;
  p = p * s - 0.3332985605f;
  p = p * s + 0.9999993329f;
  p = p * a;
  const float steep = 0.5f * kPi - p;
  p = ay > ax ? steep : p;
  const float rear = kPi - p;
  p = x < 0.0f ? rear : p;
  return std::copysign(p, y);
}

}  // namespace toss
