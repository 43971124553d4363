// SPDX-License-Identifier: BSD-3-Clause
#include "Beam.h"

#include <algorithm>
#include <cmath>

#include "Random.h"

namespace toss::simulation {
namespace {

using Eigen::Vector3d;

/// What the random numbers of a beam are for.
enum Purpose : std::uint64_t {
  kRange = 100,
  kIntensity,
  kLoss,
  kMirror,
  kStraddle,
  kWeight,
  kSide
};

/// Whether the patch of surface around a point is wet, polished or worn smooth.
bool isGlossy(const Vector3d& point, double share) {
  constexpr double kPatch = 1.5;
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    key = hash(key, static_cast<std::uint64_t>(
                        static_cast<std::int64_t>(std::floor(point[axis] / kPatch))));
  }
  return uniformOf(key) < share;
}

}  // namespace

BeamErrors errorsOf(const SensorModel& sensor) {
  const bool ouster = sensor.name.rfind("OS", 0) == 0;
  return ouster ? BeamErrors{0.015, 0.001, 0.01} : BeamErrors{0.02, 0.002, 0.01};
}

Beam::Beam(const RayCaster& caster, const SensorModel& sensor, bool noise)
    : caster_(caster), sensor_(sensor), errors_(errorsOf(sensor)), noise_(noise) {}

RayHit Beam::firstOpaque(const Vector3d& origin, const Vector3d& direction, double share,
                         std::uint64_t key) const {
  constexpr std::uint64_t kMostSurfaces = 12;
  double nearest = 0.01;
  for (std::uint64_t i = 0; i < kMostSurfaces; ++i) {
    const RayHit hit = caster_.cast(origin, direction, share, nearest, sensor_.maxRange);
    if (hit.range < 0.0 || !noise_) return hit;
    if (uniformOf(hash(key, i)) >= reflectionOf(hit.surface.material).transparency) return hit;
    nearest = hit.range + 1e-3;
  }
  return {};
}

double Beam::straddled(const Vector3d& origin, const Vector3d& direction, double share,
                       double range, std::uint64_t key) const {
  // A second ray on the rim of the beam, for some beams only: it costs as much as the first.
  constexpr double kShare = 0.25, kHalfWidth = 0.0015;
  if (uniformOf(hash(key, kStraddle)) >= kShare) return range;
  const std::uint64_t side = hash(key, kSide);
  const Vector3d any{gaussianOf(side), gaussianOf(side + 1), gaussianOf(side + 2)};
  const Vector3d rim = (direction + kHalfWidth * any.cross(direction).normalized()).normalized();
  const double other = caster_.cast(origin, rim, share, 0.01, sensor_.maxRange).range;

  // Nearer together, the pulses are one anyway; farther apart, the sensor tells them apart.
  constexpr double kNearest = 0.1, kFarthest = 1.2;
  const double difference = std::abs(other - range);
  if (other < 0.0 || difference < kNearest || difference > kFarthest) return range;
  return range + 0.5 * uniformOf(hash(key, kWeight)) * (other - range);
}

double Beam::mirroredDetour(const Vector3d& point, const Vector3d& direction, const RayHit& hit,
                            double share) const {
  constexpr double kLongest = 40.0;
  const Vector3d mirrored = direction - 2.0 * direction.dot(hit.normal) * hit.normal;
  return caster_.cast(point + 0.01 * hit.normal, mirrored.normalized(), share, 0.0, kLongest).range;
}

bool Beam::isLost(double reflected, double range, std::uint64_t key) const {
  // So that asphalt fades out at about 60 m for an HDL-64E on a car's roof.
  constexpr double kStrength = 25.0;
  const double reach = sensor_.maxRange / range;
  const double kept =
      (1.0 - errors_.loss) * (1.0 - std::exp(-kStrength * reflected * reach * reach));
  return uniformOf(hash(key, kLoss)) >= kept;
}

double Beam::reported(double range, std::uint64_t key) const {
  const double noisy = range + errors_.rangeDeviation * gaussianOf(hash(key, kRange));
  return errors_.rangeStep * std::round(noisy / errors_.rangeStep);
}

BeamReturn Beam::measure(const Vector3d& origin, const Vector3d& direction, double share,
                         std::uint64_t key) const {
  BeamReturn result;
  const RayHit hit = firstOpaque(origin, direction, share, key);
  if (hit.range < sensor_.minRange) return result;

  const Reflection& reflection = reflectionOf(hit.surface.material);
  const double cosine = std::abs(hit.normal.dot(direction));
  const double intensity = reflection.reflectivity * (0.25 + 0.75 * cosine);
  result = {hit.range, static_cast<float>(intensity), hit.surface.label, hit.instance};
  if (!noise_) return result;

  const Vector3d point = origin + hit.range * direction;
  constexpr double kMirrored = 0.4;
  if (cosine < 0.5 && isGlossy(point, reflection.gloss) &&
      uniformOf(hash(key, kMirror)) < kMirrored) {
    const double detour = mirroredDetour(point, direction, hit, share);
    if (detour < 0.0) return {};
    result.range += detour, result.label = semantics::kOutlier, result.instance = 0;
  }
  if (result.label != semantics::kOutlier) {
    result.range = straddled(origin, direction, share, result.range, key);
  }
  if (result.range > sensor_.maxRange ||
      isLost(reflection.reflectivity * cosine, result.range, key)) {
    return {};
  }
  result.range = reported(result.range, key);
  const double shown = intensity + 0.03 * gaussianOf(hash(key, kIntensity));
  result.intensity = static_cast<float>(0.01 * std::round(100.0 * std::clamp(shown, 0.0, 1.0)));
  return result;
}

}  // namespace toss::simulation
