// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/geometry/SensorModel.h>
#include <toss/segmentation/ProjectionOptions.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Directions of the returns of one scan, as the range image needs them.
struct Directions {
  /// Azimuth [rad] in [-pi, pi], counter-clockwise from the x axis, shape [n].
  std::vector<float> azimuth;
  /// Tangent of the elevation, z / horizontal distance, shape [n].
  std::vector<float> slope;
  /// Whether the return is finite and not at the origin, shape [n]. Where it is 0, the two others
  /// hold no meaning.
  std::vector<std::uint8_t> valid;
};

/// What the rows of a scan were taken from.
enum class RowSource { Ring, Order, Elevation, Equation };

/// Finds the row (beam) of every return, by the best evidence that the scan offers (spec section
/// 1.4). Rows by beam keep 92 % of HDL-64E returns in pixels of their own, rows by elevation 79 %.
class RowAssignment {
 public:
  /// `sensor` must have at least one beam; throws UserError otherwise.
  RowAssignment(const SensorModel& sensor, RowPolicy policy);

  /// Sets `row` of every valid return (0 = topmost, shape [n]) and the elevation of each row [rad]
  /// (topmost first, shape [rows]). `ring`: beam index of each return or empty. Elevations are
  /// measured where the rows are beams, and the sensor's table otherwise. Throws UserError where a
  /// ring lies outside the sensor's beams.
  RowSource assign(const Directions& directions, const std::vector<std::uint16_t>& ring,
                   std::vector<std::uint16_t>& row, std::vector<float>& elevations);

 private:
  bool fromOrder(const Directions& directions, std::vector<std::uint16_t>& row);
  void findWraps(const Directions& directions);
  int findRings(const Directions& directions);
  int shiftToTable() const;
  void fromElevation(const Directions& directions, std::vector<std::uint16_t>& row) const;
  void fromEquation(const Directions& directions, std::vector<std::uint16_t>& row) const;
  void findMedianSlopes(const Directions& directions, const std::vector<std::uint16_t>& row);
  void measureElevations(std::vector<float>& elevations) const;

  SensorModel sensor_;
  RowPolicy policy_;
  /// Slope half-way between row r and r + 1, shape [rows - 1], falling.
  std::vector<float> boundary_;
  /// First candidate row for each of evenly spaced slopes.
  std::vector<std::uint16_t> firstRow_;
  float topSlope_ = 0.0f, cellsPerSlope_ = 0.0f;
  /// First return of each ring of a scan in ring order, and the number of returns.
  std::vector<std::size_t> ringBegin_;
  /// Returns at which a ring may begin, shape [n], in whole words.
  std::vector<std::uint8_t> mark_;
  std::vector<std::vector<float>> samples_;
  /// Median slope of the returns of each row, NaN where there are too few.
  std::vector<float> medians_;
};

}  // namespace toss
