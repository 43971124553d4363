// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/render/Camera.h>

#include <Eigen/Geometry>

namespace toss {

/// How the camera goes with the sensor.
enum class CameraMode {
  Chase,   ///< behind and above the sensor, looking along its heading
  Top,     ///< straight down on the sensor, north up, no perspective
  Follow,  ///< as the user turned it, staying with the sensor
  Free     ///< as the user put it
};

/// The camera of CameraMode::Chase and Top, smooth from scan to scan. Other modes leave what the
/// user has turned alone.
class CameraGuide {
 public:
  /// The camera for the sensor at `mapFromSensor`; `previous`: where it is now. Size of the picture
  /// as in `previous`.
  Camera next(CameraMode mode, const Eigen::Isometry3d& mapFromSensor, const Camera& previous);

 private:
  /// Heading of the sensor [rad], smoothed; NaN before the first scan.
  double heading_ = std::nan("");
};

}  // namespace toss
