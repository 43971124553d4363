// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/NearestNeighbors.h>

namespace toss {
namespace {

struct Best {
  double squared;
  std::int32_t index;
};

void improve(const CellOrder& queries, std::uint32_t q, const CellOrder& targets,
             std::uint32_t first, std::uint32_t end, Best& best) {
  for (std::uint32_t t = first; t < end; ++t) {
    const double squared = squaredDistance(queries.x[q], queries.y[q], queries.z[q], targets.x[t],
                                           targets.y[t], targets.z[t]);
    const auto index = static_cast<std::int32_t>(targets.index[t]);
    const bool tie = best.index >= 0 && squared == best.squared && index < best.index;
    if (squared < best.squared || tie) best = {squared, index};
  }
}

}  // namespace

std::vector<std::int32_t> nearestNeighbors(const CellOrder& queries, const CellOrder& targets,
                                           double radius, std::size_t queryCount) {
  std::vector<Best> best(queries.places(), Best{radius * radius, -1});
  joinCells(queries, targets, [&](std::size_t cell, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t q = queries.begin[cell]; q < queries.begin[cell + 1]; ++q) {
      improve(queries, q, targets, first, end, best[q]);
    }
  });
  std::vector<std::int32_t> nearest(queryCount, -1);
  for (std::size_t q = 0; q < best.size(); ++q) nearest[queries.index[q]] = best[q].index;
  return nearest;
}

}  // namespace toss
