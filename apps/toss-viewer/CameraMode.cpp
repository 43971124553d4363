// SPDX-License-Identifier: BSD-3-Clause
#include "CameraMode.h"

#include <cmath>

namespace toss {
namespace {

constexpr double kPi = 3.14159265358979323846;

double between(double from, double to, double share) {
  return from + share * std::remainder(to - from, 2.0 * kPi);
}

}  // namespace

Camera CameraGuide::next(CameraMode mode, const Eigen::Isometry3d& mapFromSensor,
                         const Camera& previous) {
  constexpr double kTurnPerScan = 0.2;
  const Eigen::Vector3d ahead = mapFromSensor.linear().col(0);
  const double measured = std::atan2(ahead.y(), ahead.x());
  heading_ = std::isnan(heading_) ? measured : between(heading_, measured, kTurnPerScan);
  Camera camera = previous;
  if (mode == CameraMode::Free) return camera;
  camera.target = mapFromSensor.translation();
  if (mode == CameraMode::Follow) return camera;
  camera.perspective = mode == CameraMode::Chase;
  camera.azimuth = mode == CameraMode::Chase ? heading_ + kPi : -0.5 * kPi;
  camera.elevation = mode == CameraMode::Chase ? 0.5 : 0.5 * kPi;
  camera.distance = mode == CameraMode::Chase ? 55.0 : 160.0;
  if (mode == CameraMode::Chase)
    camera.target += 8.0 * Eigen::Vector3d(std::cos(heading_), std::sin(heading_), 0.0);
  return camera;
}

}  // namespace toss
