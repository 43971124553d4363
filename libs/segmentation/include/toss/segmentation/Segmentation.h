// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/segmentation/NearbyGround.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace toss {

/// What a return is, decided by segmentation; exactly one per input point (spec, pipeline
/// contract).
enum class PointClass : std::uint8_t {
  Invalid,      ///< not finite, at the origin, or on the robot's own body
  OutOfRange,   ///< nearer than min_range or farther than max_range
  Ground,       ///< on the traversable surface
  BelowGround,  ///< clearly under it: mirror and multi-path returns
  Unclustered,  ///< above ground, but in no instance
  Instance      ///< above ground, in an instance
};

/// Coordinates of a scan in the level frame: axes parallel to the map's, origin at the sensor [m].
/// Heights are along gravity whatever the robot's roll and pitch, and floats stay exact however far
/// from the map's origin the robot is: map coordinate = level coordinate + sensor position in map.
struct LevelPoints {
  /// Shape [n] each, NaN where the input is not finite.
  std::vector<float> x, y, z;
};

/// Per-point result of segmentation, index-aligned with the scan.
struct Segmentation {
  /// Shape [n].
  std::vector<PointClass> pointClass;
  /// 0 = none, 1..instanceCount = number of the instance, shape [n].
  std::vector<std::int32_t> instance;
  /// Height over the local ground plane [m], NaN where no ground is known, shape [n].
  std::vector<float> heightAboveGround;
  /// How high ground may lie where none is known.
  NearbyGround nearbyGround;
  /// Number of instances N.
  std::int32_t instanceCount = 0;

  /// Point indices grouped by instance: those of instance k (1-based) are
  /// members[memberBegin[k - 1]] .. members[memberBegin[k] - 1], ascending.
  /// Shapes [sum of sizes] and [instanceCount + 1].
  std::vector<std::int32_t> members, memberBegin;

  /// heightAboveGround of a point, NaN where that is empty: without the ground stage.
  float knownHeight(std::size_t point) const {
    return point < heightAboveGround.size() ? heightAboveGround[point]
                                            : std::numeric_limits<float>::quiet_NaN();
  }
};

/// Height of a return over the ground [m]; where none is known, the least that it can be: minus
/// infinity where none is known nearby either.
float clearanceOf(std::size_t point, const LevelPoints& points, const Segmentation& segmentation);

/// Whether all returns of instance `k` (from 1) are more than `clearance` [m] above the ground.
bool isFloating(std::int32_t k, float clearance, const LevelPoints& points,
                const Segmentation& segmentation);

}  // namespace toss
