// SPDX-License-Identifier: BSD-3-Clause
#include "PointSpacing.h"

#include <toss/render/PointSample.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace toss {
namespace {

float nearestOther(const std::vector<Eigen::Vector3f>& points, std::size_t query) {
  const Eigen::Vector3f center = points[query];
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float squared = (points[i] - center).squaredNorm();
    if (i != query && squared < nearest) nearest = squared;
  }
  return std::sqrt(nearest);
}

}  // namespace

double pointSpacing(const std::vector<Eigen::Vector3f>& points) {
  // A tree over millions of points would cost more than this many plain searches.
  constexpr std::size_t kQueries = 40;
  if (points.size() < 2) return 0.1;
  std::vector<float> distances;
  for (const std::uint32_t query : sampleIndices(points.size(), kQueries))
    distances.push_back(nearestOther(points, query));
  if (distances.empty()) return 0.1;
  std::nth_element(distances.begin(),
                   distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
                   distances.end());
  return std::max(1e-3, static_cast<double>(distances[distances.size() / 2]));
}

}  // namespace toss
