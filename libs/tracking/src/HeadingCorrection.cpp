// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/HeadingCorrection.h>

#include <cmath>
#include <utility>

namespace toss {

double wrapYaw(double yaw) {
  const double wrapped = std::remainder(yaw, M_PI);
  return wrapped < 0.5 * M_PI ? wrapped : wrapped - M_PI;
}

Box alignedWithYaw(const Box& box, double yaw) {
  Box aligned = box;
  const double quarterTurns = std::nearbyint((yaw - box.yaw) / (0.5 * M_PI));
  aligned.yaw += quarterTurns * 0.5 * M_PI;
  if (std::fmod(quarterTurns, 2.0) != 0.0) std::swap(aligned.length, aligned.width);
  return aligned;
}

}  // namespace toss
