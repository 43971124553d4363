// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/Segmentation.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace toss {

/// Picks the returns near places of a scan in one pass over all of them, by squares of the ground
/// plane, so that only few have to be looked at closely.
class NearbyReturns {
 public:
  /// What may lie near: returns outside instances (Ground and Unclustered), or in instances.
  enum class Of : std::uint8_t { NoInstance = 1, Instances = 2 };

  /// Squares of 1 m along each axis; the grid is centred at the sensor.
  static constexpr int kSquares = 256;

  /// Forgets all places.
  void clear() { marks_.fill(0); }
  /// Adds an area of the level frame [m]; areas beyond the grid count as its outermost squares.
  void mark(const Eigen::AlignedBox2f& area, Of what);
  /// Finds all returns of the wanted kinds that lie in a marked area, and others near it; from then
  /// on they are the range begin()..end(), by ascending point.
  void find(const LevelPoints& points, const std::vector<PointClass>& pointClass);

  const std::int32_t* begin() const { return found_.data(); }
  const std::int32_t* end() const { return found_.data() + count_; }
  std::size_t size() const { return count_; }

 private:
  /// Bits of Of for each square, by x and then y.
  std::array<std::uint8_t, kSquares * kSquares> marks_{};
  /// Only grows; the first `count_` hold what was found.
  std::vector<std::int32_t> found_;
  std::size_t count_ = 0;
};

}  // namespace toss
