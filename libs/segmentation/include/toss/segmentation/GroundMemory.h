// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/NearbyGround.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

/// The ground that scans have known so far, in squares of the map. What is too far from one scan
/// for its ground to be known is mostly near to another.
class GroundMemory {
 public:
  GroundMemory();

  /// Adds the ground that a scan knows which was taken at `time` [s] and `sensorPosition` [m, map
  /// frame]. Of a square the mean of its last scans counts, back to a pause of ten seconds. Squares
  /// a multiple of 1 km apart forget each other.
  void add(double time, const Eigen::Vector3d& sensorPosition, const NearbyGround& ground);
  /// Replaces `ground` by all that is known by now within `extent` [m] of a sensor.
  void recall(const Eigen::Vector3d& sensorPosition, double extent, NearbyGround& ground) const;

 private:
  /// Squares along a side: those a multiple of this apart share their place.
  static constexpr std::int64_t kSide = 256;

  struct Square {
    /// Which of the squares of this place it is; at first none that has ground.
    std::int64_t row = std::numeric_limits<std::int64_t>::max(), column = row;
    /// When it was last known [s], and how high it is [m, map frame].
    double time = 0.0, height = 0.0;

    bool is(std::int64_t r, std::int64_t c) const { return row == r && column == c; }
  };
  static std::size_t placeOf(std::int64_t row, std::int64_t column) {
    constexpr std::int64_t kLow = kSide - 1;
    return static_cast<std::size_t>((row & kLow) * kSide + (column & kLow));
  }

  std::vector<Square> squares_;
};

}  // namespace toss
