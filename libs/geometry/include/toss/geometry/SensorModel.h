// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace toss {

/// Geometry of a spinning multi-beam LiDAR: what the range image and the simulator need to know.
struct SensorModel {
  /// Name as in config/sensors, e.g. "HDL-64E".
  std::string name;
  /// Elevation of each beam above the sensor's horizontal plane [rad], topmost first, shape [rows].
  std::vector<float> elevations;
  /// Firings per revolution at the usual rate: native azimuth step = 2 pi / columns.
  int columns = 0;
  /// Shortest and longest range that the sensor reports [m].
  float minRange = 0.0f, maxRange = 0.0f;

  int rows() const { return static_cast<int>(elevations.size()); }
};

/// The models that TOSS knows: HDL-64E (its two blocks: 1/3 degree above, 1/2 degree below),
/// HDL-32E, VLP-16, OS0-128, OS1-64 (spec section 1.3); OS0-64, OS0-32, OS1-128, OS1-32, OS2-128
/// (data sheets).
const std::vector<SensorModel>& knownSensors();

/// The model of that name (case-sensitive). Throws UserError naming the nearest known name.
const SensorModel& sensorByName(const std::string& name);

}  // namespace toss
