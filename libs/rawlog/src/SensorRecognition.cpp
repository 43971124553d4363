// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/SensorRecognition.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace toss {
namespace {

constexpr std::size_t kSample = 20000;
constexpr float kNearest = 5.0f;
constexpr float kFullTurn = 6.2831853f;
/// Too few returns tell nothing.
constexpr std::size_t kFewest = 200;

std::string lettersAndDigits(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)))
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Elevations [rad] of a sample of the far returns, in the scan's order.
std::vector<float> sampleElevations(const PointCloud& points) {
  std::vector<float> elevations;
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSample);
  for (std::size_t i = 0; i < points.size(); i += step) {
    const float horizontal = std::hypot(points.x[i], points.y[i]);
    const float range = std::hypot(horizontal, points.z[i]);
    if (std::isfinite(range) && range >= kNearest)
      elevations.push_back(std::atan2(points.z[i], horizontal));
  }
  return elevations;
}

struct BeamHit {
  std::size_t beam = 0;
  /// Distance from the beam in units of the spacing on that side.
  float offset = 0.0f;
};

BeamHit nearestBeam(float elevation, const std::vector<float>& beams) {
  const auto below = std::lower_bound(beams.begin(), beams.end(), elevation, std::greater<float>());
  std::size_t beam = static_cast<std::size_t>(below - beams.begin());
  if (beam == beams.size() || (beam > 0 && beams[beam - 1] - elevation < elevation - beams[beam]))
    --beam;
  const bool above = elevation > beams[beam];
  const std::size_t other =
      above ? (beam == 0 ? 1 : beam - 1) : (beam + 1 == beams.size() ? beam - 1 : beam + 1);
  return {beam, std::abs(elevation - beams[beam]) / std::abs(beams[other] - beams[beam])};
}

BeamAgreement agreement(const std::vector<float>& elevations, const SensorModel& sensor) {
  std::vector<std::size_t> hits(sensor.elevations.size());
  std::size_t inside = 0, nearBeam = 0;
  for (const float elevation : elevations) {
    const BeamHit hit = nearestBeam(elevation, sensor.elevations);
    if (hit.offset > 0.5f) continue;
    ++inside;
    nearBeam += hit.offset < 0.25f;
    ++hits[hit.beam];
  }
  if (inside == 0) return {};
  const double fewest = 0.1 * static_cast<double>(inside) / static_cast<double>(hits.size());
  const auto used = std::count_if(hits.begin(), hits.end(), [&](std::size_t count) {
    return static_cast<double>(count) > fewest;
  });
  BeamAgreement result;
  result.inside = static_cast<double>(inside) / static_cast<double>(elevations.size());
  result.nearBeam = static_cast<double>(nearBeam) / static_cast<double>(inside);
  result.beamsUsed = static_cast<double>(used) / static_cast<double>(hits.size());
  return result;
}

/// Rings of a scan that is stored ring after ring: in each the azimuth runs once around. Scans that
/// are stored otherwise give 1 or thousands.
int countRings(const PointCloud& points) {
  int rings = 1;
  float last = 0.0f;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool valid = std::isfinite(points.x[i]) && std::isfinite(points.y[i]) &&
                       (points.x[i] != 0.0f || points.y[i] != 0.0f);
    if (!valid) continue;
    float azimuth = std::atan2(points.y[i], points.x[i]);
    if (azimuth < 0.0f) azimuth += kFullTurn;
    rings += std::abs(azimuth - last) > 0.5f * kFullTurn;
    last = azimuth;
  }
  return rings;
}

/// Scans that were corrected for motion, or whose beams start apart, blur the beams; the number of
/// rings still tells the model.
bool beamsFit(const BeamAgreement& found, const SensorModel& sensor, int rings) {
  const bool ringsFit = std::abs(rings - sensor.rows()) <= 4;
  return found.inside > 0.9 && found.beamsUsed > 0.35 && (found.nearBeam > 0.55 || ringsFit);
}

std::string modelByBeams(const PointCloud& points) {
  const std::vector<float> elevations = sampleElevations(points);
  if (elevations.size() < kFewest) return "";
  const int rings = countRings(points);
  std::string best;
  double bestScore = 0.0;
  for (const SensorModel& sensor : knownSensors()) {
    const BeamAgreement found = agreement(elevations, sensor);
    if (beamsFit(found, sensor, rings) && found.score() > bestScore) {
      bestScore = found.score();
      best = sensor.name;
    }
  }
  return best;
}

bool isKnown(const std::string& model) {
  const std::vector<SensorModel>& known = knownSensors();
  return std::any_of(known.begin(), known.end(),
                     [&](const SensorModel& sensor) { return sensor.name == model; });
}

}  // namespace

std::string sensorNamedIn(const std::string& given) {
  const std::string text = lettersAndDigits(given);
  for (const SensorModel& sensor : knownSensors()) {
    std::string name = lettersAndDigits(sensor.name);
    // The E of the HDL series is often left out.
    if (name.back() == 'e') name.pop_back();
    if (text.find(name) != std::string::npos) return sensor.name;
  }
  return "";
}

BeamAgreement beamAgreement(const PointCloud& points, const SensorModel& sensor) {
  const std::vector<float> elevations = sampleElevations(points);
  return elevations.empty() ? BeamAgreement() : agreement(elevations, sensor);
}

std::string recognizeSensor(const PosedScan& scan) {
  if (!scan.sensorModel.empty()) return scan.sensorModel;
  if (scan.beams) return isKnown(scan.beams->name) ? scan.beams->name : "";
  const std::string labelled = sensorNamedIn(scan.sensorLabel);
  return labelled.empty() ? modelByBeams(scan.points) : labelled;
}

}  // namespace toss
