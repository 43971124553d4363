// SPDX-License-Identifier: BSD-3-Clause
#include <toss/segmentation/Segmentation.h>

#include <algorithm>
#include <cmath>

namespace toss {

float clearanceOf(std::size_t point, const LevelPoints& points, const Segmentation& segmentation) {
  const float known = segmentation.knownHeight(point);
  if (!std::isnan(known)) return known;
  return points.z[point] - segmentation.nearbyGround.highest(points.x[point], points.y[point]);
}

bool isFloating(std::int32_t k, float clearance, const LevelPoints& points,
                const Segmentation& segmentation) {
  const std::int32_t* const begin = &segmentation.memberBegin[static_cast<std::size_t>(k) - 1];
  const std::int32_t* const members = segmentation.members.data();
  return std::all_of(members + begin[0], members + begin[1], [&](std::int32_t member) {
    return clearanceOf(static_cast<std::size_t>(member), points, segmentation) > clearance;
  });
}

}  // namespace toss
