// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/SensorChoice.h>
#include <toss/rawlog/SensorRecognition.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

struct Sighting {
  float elevation;
  std::uint16_t ring;
};

std::vector<Sighting> sightings(const PointCloud& points) {
  std::vector<Sighting> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float horizontal = std::hypot(points.x[i], points.y[i]);
    if (!std::isfinite(horizontal) || !std::isfinite(points.z[i]) || horizontal <= 0.0f) continue;
    result.push_back({std::atan2(points.z[i], horizontal),
                      points.ring.empty() ? std::uint16_t{0} : points.ring[i]});
  }
  return result;
}

float medianElevation(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A beam per ring, at the median elevation of its returns.
std::vector<float> elevationsByRing(const std::vector<Sighting>& all) {
  std::uint16_t last = 0;
  for (const Sighting& s : all) last = std::max(last, s.ring);
  std::vector<std::vector<float>> byRing(static_cast<std::size_t>(last) + 1);
  for (const Sighting& s : all) byRing[s.ring].push_back(s.elevation);
  std::vector<float> elevations;
  for (const std::vector<float>& ring : byRing)
    if (!ring.empty()) elevations.push_back(medianElevation(ring));
  std::sort(elevations.rbegin(), elevations.rend());
  return elevations;
}

/// Evenly spaced rows over what the scan spans: all that can be said without rings.
std::vector<float> evenElevations(const std::vector<Sighting>& all) {
  constexpr int kRows = 64;
  const auto byElevation = [](const Sighting& a, const Sighting& b) {
    return a.elevation < b.elevation;
  };
  const auto [low, high] = std::minmax_element(all.begin(), all.end(), byElevation);
  std::vector<float> elevations(kRows);
  for (int r = 0; r < kRows; ++r)
    elevations[static_cast<std::size_t>(r)] =
        high->elevation - (high->elevation - low->elevation) * static_cast<float>(r) / (kRows - 1);
  return elevations;
}

SensorModel measuredSensor(const PosedScan& scan) {
  constexpr int kColumns = 2048;
  constexpr float kMinRange = 0.3f, kMaxRange = 200.0f;
  const std::vector<Sighting> all = sightings(scan.points);
  if (all.empty()) return sensorByName("HDL-64E");
  return {"measured", scan.points.ring.empty() ? evenElevations(all) : elevationsByRing(all),
          kColumns, kMinRange, kMaxRange};
}

}  // namespace

void SensorOptions::visit(OptionVisitor& v) {
  v.string(
      {"model", "", "Model of the sensor, such as HDL-64E, or auto to find out", "config/sensors"},
      model);
}

SensorChoice chooseSensor(const PosedScan& scan) {
  const std::string recognized = recognizeSensor(scan);
  if (scan.beams) return {*scan.beams, recognized, "auto"};
  if (!recognized.empty()) return {sensorByName(recognized), recognized, recognized};
  return {measuredSensor(scan), "", "auto"};
}

}  // namespace toss
