// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/mapping/StaticMap.h>

#include <numeric>
#include <random>

namespace toss::test {

/// Returns of a scan with coordinates in [-reach, reach] m around the sensor.
struct RandomReturns {
  LevelPoints level;
  std::vector<float> intensity;
  std::vector<std::int32_t> all;
  Eigen::Vector3d sensorPosition = Eigen::Vector3d::Zero();

  RandomReturns(std::mt19937& random, std::size_t n, float reach) : intensity(n), all(n) {
    std::uniform_real_distribution<float> coordinate(-reach, reach), unit(0.0f, 1.0f);
    for (std::vector<float>* axis : {&level.x, &level.y, &level.z}) {
      axis->resize(n);
      for (float& value : *axis) value = coordinate(random);
    }
    for (float& value : intensity) value = unit(random);
    std::iota(all.begin(), all.end(), 0);
  }
  ScanReturns scan() const { return {level, intensity, sensorPosition}; }
};

/// A run of returns of nobody.
inline VoxelRun voxelRun(VoxelKey key, std::uint64_t count, std::uint64_t x, std::uint64_t y,
                         std::uint64_t z, std::uint64_t intensity) {
  return {key, count << 60 | x << 40 | y << 20 | z, intensity};
}

inline bool operator==(const MapPoint& a, const MapPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.intensity == b.intensity;
}

inline bool same(const std::vector<MapPoint>& a, const std::vector<MapPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const MapPoint& p, const MapPoint& q) { return test::operator==(p, q); });
}

}  // namespace toss::test
