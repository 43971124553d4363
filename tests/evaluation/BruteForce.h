// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/LabelledCloud.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

/// Slow, plain statements of the definitions, to hold the library against.
namespace toss::test {

/// Points within `extent` [m] of the origin per axis; every `quantum` [m] so that ties in distance
/// and points on the faces of voxels occur. Labels 9 and 252, one moving point in four.
inline LabelledCloud randomCloud(std::mt19937& random, std::size_t n, double extent,
                                 double quantum) {
  std::uniform_int_distribution<int> step(-static_cast<int>(extent / quantum),
                                          static_cast<int>(extent / quantum));
  std::uniform_int_distribution<int> kind(0, 3);
  LabelledCloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    const auto coordinate = [&] { return static_cast<float>(step(random) * quantum); };
    const float x = coordinate(), y = coordinate(), z = coordinate();
    cloud.add(x, y, z, kind(random) == 0 ? 252u : 9u);
  }
  return cloud;
}

inline double distanceSquared(const LabelledCloud& a, std::size_t i, const LabelledCloud& b,
                              std::size_t j) {
  return std::pow(double(a.x[i]) - double(b.x[j]), 2) +
         std::pow(double(a.y[i]) - double(b.y[j]), 2) +
         std::pow(double(a.z[i]) - double(b.z[j]), 2);
}

/// Nearest point of `targets` to point `i` of `queries` by trying all, lowest index first; -1 if
/// none is strictly nearer than `radius`.
inline int nearestByTryingAll(const LabelledCloud& queries, std::size_t i,
                              const LabelledCloud& targets, double radius) {
  int best = -1;
  double bestSquared = radius * radius;
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const double squared = distanceSquared(queries, i, targets, j);
    if (squared < bestSquared) bestSquared = squared, best = static_cast<int>(j);
  }
  return best;
}

/// Voxel grid with nearest label, from the definition.
inline LabelledCloud voxelizeByTryingAll(const LabelledCloud& cloud, double voxelSize) {
  const float perMetre = 1.0f / static_cast<float>(voxelSize);
  // z first: the order of PCL, x fastest.
  std::map<std::array<long, 3>, std::vector<std::size_t>> voxels;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    voxels[{std::lround(std::floor(cloud.z[i] * perMetre)),
            std::lround(std::floor(cloud.y[i] * perMetre)),
            std::lround(std::floor(cloud.x[i] * perMetre))}]
        .push_back(i);
  }
  LabelledCloud result;
  for (const auto& [voxel, members] : voxels) {
    std::array<double, 3> sum{};
    for (const std::size_t i : members) {
      sum[0] += double(cloud.x[i]), sum[1] += double(cloud.y[i]), sum[2] += double(cloud.z[i]);
    }
    const auto n = static_cast<double>(members.size());
    result.add(static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n),
               static_cast<float>(sum[2] / n), 0);
    const int nearest = nearestByTryingAll(result, result.size() - 1, cloud, 1e9);
    result.label.back() = cloud.label[static_cast<std::size_t>(nearest)];
  }
  return result;
}

inline void append(const LabelledCloud& from, LabelledCloud& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    to.add(from.x[i], from.y[i], from.z[i], from.label[i]);
  }
}

inline bool operator==(const LabelledCloud& a, const LabelledCloud& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.label == b.label;
}

}  // namespace toss::test
