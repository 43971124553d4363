// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/CellOrder.h>

#include <cstdint>
#include <vector>

namespace toss {

/// Squared distance [m^2] of two points, in double precision: one formula for all comparisons, so
/// that every search agrees with brute force to the bit.
inline double squaredDistance(float ax, float ay, float az, float bx, float by, float bz) {
  const double dx = static_cast<double>(ax) - bx, dy = static_cast<double>(ay) - by,
               dz = static_cast<double>(az) - bz;
  return dx * dx + dy * dy + dz * dz;
}

/// For each point of the cloud behind `queries`, the point of the cloud behind `targets` that is
/// nearest among those strictly nearer than `radius` [m], the lowest index where several are; -1
/// where there is none. `radius` must not exceed the cell size of both orders. `queryCount`: points
/// of the query cloud. Shape of the result [queryCount].
std::vector<std::int32_t> nearestNeighbors(const CellOrder& queries, const CellOrder& targets,
                                           double radius, std::size_t queryCount);

}  // namespace toss
