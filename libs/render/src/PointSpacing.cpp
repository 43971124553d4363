// SPDX-License-Identifier: BSD-3-Clause
#include "PointSpacing.h"

#include <toss/render/PointSample.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace toss {
namespace {

float thirdNearest(const std::vector<Eigen::Vector3f>& points, std::size_t query) {
  const Eigen::Vector3f center = points[query];
  constexpr float kFar = std::numeric_limits<float>::max();
  // The query itself is the nearest.
  std::array<float, 4> nearest = {kFar, kFar, kFar, kFar};
  for (const Eigen::Vector3f& point : points) {
    const float squared = (point - center).squaredNorm();
    if (squared >= nearest.back()) continue;
    std::size_t place = nearest.size() - 1;
    for (; place > 0 && nearest[place - 1] > squared; --place) nearest[place] = nearest[place - 1];
    nearest[place] = squared;
  }
  return std::sqrt(nearest.back());
}

}  // namespace

double pointSpacing(const std::vector<Eigen::Vector3f>& points) {
  // A tree over millions of points would cost more than this many plain searches.
  constexpr std::size_t kQueries = 40;
  std::vector<float> distances;
  if (points.size() >= 4)
    for (const std::uint32_t query : sampleIndices(points.size(), kQueries))
      distances.push_back(thirdNearest(points, query));
  if (distances.empty()) return 0.1;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::max(1e-3, static_cast<double>(*middle));
}

}  // namespace toss
