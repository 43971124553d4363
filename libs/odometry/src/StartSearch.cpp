// SPDX-License-Identifier: BSD-3-Clause
#include "StartSearch.h"

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Distance of the places that are tried [m]: an alignment finds its way from half of it.
constexpr double kStep = 1.0;
/// Places of which the alignment is tried, by how well the points fit there.
constexpr std::size_t kAligned = 6;
/// Scale [m^2] of the kernel that alignments are compared by: fine, for all are aligned by then.
constexpr double kFineScale = 0.05;

/// Places in the plane that the sensor spins in, the nearest first.
std::vector<Eigen::Vector3d> placesWithin(double reach) {
  std::vector<Eigen::Vector3d> places;
  const int steps = static_cast<int>(reach / kStep);
  for (int x = -steps; x <= steps; ++x)
    for (int y = -steps; y <= steps; ++y)
      if (std::hypot(x, y) * kStep <= reach) places.emplace_back(kStep * x, kStep * y, 0.0);
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  return places;
}

std::vector<Eigen::Vector3d> everyFourth(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < points.size(); i += 4) some.push_back(points[i]);
  return some;
}

}  // namespace

Eigen::Isometry3d findStart(const std::vector<Eigen::Vector3d>& points, const LocalMap& map,
                            const Eigen::Isometry3d& last, double reach,
                            const RegistrationLimits& limits) {
  const std::vector<Eigen::Vector3d> some = everyFourth(points);
  std::vector<std::pair<double, Eigen::Isometry3d>> places;
  for (const Eigen::Vector3d& place : placesWithin(reach)) {
    const Eigen::Isometry3d pose = last * Eigen::Translation3d(place);
    places.emplace_back(fitness(some, map, pose, limits), pose);
  }
  std::stable_sort(places.begin() + 1, places.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  places.resize(std::min(places.size(), kAligned));
  RegistrationLimits fine = limits;
  fine.kernelScale = kFineScale;
  for (auto& [score, pose] : places) {
    pose = align(points, map, pose, limits).mapFromSensor;
    score = fitness(points, map, pose, fine);
  }
  return std::max_element(places.begin(), places.end(),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

}  // namespace toss
