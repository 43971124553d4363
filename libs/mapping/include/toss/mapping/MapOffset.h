// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace toss {

/// What is taken off the coordinates of a map that lies at `position` [m] before they become
/// floats: zero within 100 km of the origin of the frame, where floats are finer than a centimetre,
/// else the position rounded to 1 km (UTM and the like).
inline Eigen::Vector3d mapOffset(const Eigen::Vector3d& position) {
  constexpr double kFar = 100e3, kRounding = 1000.0;
  if (!(position.cwiseAbs().maxCoeff() > kFar)) return Eigen::Vector3d::Zero();
  return (position / kRounding).array().round() * kRounding;
}

}  // namespace toss
