// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/GroundMemory.h>

#include <algorithm>
#include <cmath>

namespace toss {
namespace {

/// Time after which a square is seen anew: on another level of a car park, on a bridge [s].
constexpr double kFresh = 10.0;
/// Weight of a scan in the mean of the last ones (measured: the lowest of them finds more crowns,
/// but where people walk up hills it loses some).
constexpr double kWeight = 0.2;

/// Square of the map whose first corner is next to a sensor, along one axis.
std::int64_t squareAt(double sensor) {
  return std::llround(sensor / NearbyGround::kSquare);
}

}  // namespace

GroundMemory::GroundMemory() : squares_(static_cast<std::size_t>(kSide * kSide)) {}

void GroundMemory::add(double time, const Eigen::Vector3d& sensorPosition,
                       const NearbyGround& ground) {
  const std::int64_t row = squareAt(sensorPosition.x()), column = squareAt(sensorPosition.y());
  ground.visitKnown([&](std::int64_t r, std::int64_t c, float heightFromSensor) {
    Square& square = squares_[placeOf(row + r, column + c)];
    const double height = sensorPosition.z() + static_cast<double>(heightFromSensor);
    const bool fresh = square.is(row + r, column + c) && time - square.time < kFresh;
    const double mean = square.height + kWeight * (height - square.height);
    square = {row + r, column + c, time, fresh ? mean : height};
  });
}

void GroundMemory::recall(const Eigen::Vector3d& sensorPosition, double extent,
                          NearbyGround& ground) const {
  const std::int64_t row = squareAt(sensorPosition.x()), column = squareAt(sensorPosition.y());
  ground.assign(extent, [&](std::int64_t r, std::int64_t c) {
    const Square& square = squares_[placeOf(row + r, column + c)];
    return square.is(row + r, column + c) ? static_cast<float>(square.height - sensorPosition.z())
                                          : std::numeric_limits<float>::infinity();
  });
}

}  // namespace toss
