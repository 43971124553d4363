// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/geometry/Options.h>
#include <toss/geometry/SensorModel.h>

#include <algorithm>

namespace toss {
namespace {

/// Beams at equal steps from one elevation to another [degrees], both ends included.
struct BeamBlock {
  double top, bottom;
  int rows;
};

std::vector<float> elevationsOf(const std::vector<BeamBlock>& blocks) {
  constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
  std::vector<float> elevations;
  for (const BeamBlock& block : blocks) {
    const double step = (block.top - block.bottom) / (block.rows - 1);
    for (int row = 0; row < block.rows; ++row) {
      elevations.push_back(static_cast<float>((block.top - row * step) * kRadiansPerDegree));
    }
  }
  return elevations;
}

}  // namespace

const std::vector<SensorModel>& knownSensors() {
  // HDL-64E: median elevation of each ring over real scans; the beams of a block are evenly spaced
  // to 0.2 degrees. Others: data sheets, uniform beams (OS1-64: first generation, 33.2 degrees; OS1
  // of later ones 45 degrees, 120 m to targets of 80 % up to revision 6; OS2 22.5 degrees, 240 m).
  // Where a log brings the metadata of an Ouster sensor, its own beams are used.
  static const std::vector<SensorModel> sensors = {
      {"HDL-64E", elevationsOf({{2.4, -7.9, 32}, {-8.27, -23.5, 32}}), 2011, 0.9f, 120.0f},
      {"HDL-32E", elevationsOf({{10.67, -30.67, 32}}), 2170, 1.0f, 100.0f},
      {"VLP-16", elevationsOf({{15.0, -15.0, 16}}), 1800, 0.5f, 100.0f},
      {"OS0-128", elevationsOf({{45.0, -45.0, 128}}), 1024, 0.3f, 75.0f},
      {"OS0-64", elevationsOf({{45.0, -45.0, 64}}), 1024, 0.3f, 75.0f},
      {"OS0-32", elevationsOf({{45.0, -45.0, 32}}), 1024, 0.3f, 75.0f},
      {"OS1-128", elevationsOf({{22.5, -22.5, 128}}), 1024, 0.5f, 120.0f},
      {"OS1-64", elevationsOf({{16.6, -16.6, 64}}), 1024, 0.5f, 120.0f},
      {"OS1-32", elevationsOf({{22.5, -22.5, 32}}), 1024, 0.5f, 120.0f},
      {"OS2-128", elevationsOf({{11.25, -11.25, 128}}), 1024, 1.0f, 240.0f},
  };
  return sensors;
}

const SensorModel& sensorByName(const std::string& name) {
  const std::vector<SensorModel>& sensors = knownSensors();
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const SensorModel& sensor) { return sensor.name == name; });
  if (found != sensors.end()) return *found;

  std::vector<std::string> names;
  for (const SensorModel& sensor : sensors) names.push_back(sensor.name);
  throw UserError("sensor '" + name + "'", "unknown model",
                  "did you mean '" + nearestName(name, names) + "'?");
}

}  // namespace toss
