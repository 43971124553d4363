// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/ConflictResolution.h>
#include <toss/tracking/OptimalAssignment.h>

#include <algorithm>
#include <limits>

#include "ConnectedComponents.h"

namespace toss {
namespace {

using Pairs = std::vector<AssociationPair>;

std::size_t detectionOf(const AssociationPair& pair) {
  return static_cast<std::size_t>(pair.detection);
}

std::size_t targetOf(const AssociationPair& pair) {
  return static_cast<std::size_t>(pair.target);
}

/// Ascending distinct values of one member of the pairs.
template <typename Member>
std::vector<std::int32_t> distinct(const AssociationPair* begin, const AssociationPair* end,
                                   Member member) {
  std::vector<std::int32_t> values;
  for (auto* pair = begin; pair != end; ++pair) values.push_back(pair->*member);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

int positionIn(const std::vector<std::int32_t>& values, std::int32_t value) {
  return static_cast<int>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
}

void solveComponent(const AssociationPair* begin, const AssociationPair* end, Pairs& chosen) {
  if (end - begin == 1) return chosen.push_back(*begin);
  const auto detections = distinct(begin, end, &AssociationPair::detection);
  const auto targets = distinct(begin, end, &AssociationPair::target);
  CostMatrix matrix(static_cast<int>(detections.size()), static_cast<int>(targets.size()),
                    std::numeric_limits<double>::infinity());
  for (auto* pair = begin; pair != end; ++pair) {
    matrix.at(positionIn(detections, pair->detection), positionIn(targets, pair->target)) =
        pair->cost;
  }
  const auto columnOfRow = solveGatedAssignment(matrix);
  for (auto* pair = begin; pair != end; ++pair) {
    const auto row = static_cast<std::size_t>(positionIn(detections, pair->detection));
    if (columnOfRow[row] == positionIn(targets, pair->target)) chosen.push_back(*pair);
  }
}

Pairs chooseOptimally(const Pairs& pairs, std::size_t detectionCount, std::size_t targetCount) {
  ConnectedComponents components(detectionCount + targetCount);
  for (const auto& pair : pairs) {
    components.join(detectionOf(pair), detectionCount + targetOf(pair));
  }
  Pairs grouped = pairs;
  const auto component = [&](const AssociationPair& pair) {
    return components.find(detectionOf(pair));
  };
  std::sort(grouped.begin(), grouped.end(), [&](const auto& a, const auto& b) {
    return std::make_tuple(component(a), a.detection, a.target) <
           std::make_tuple(component(b), b.detection, b.target);
  });
  Pairs chosen;
  for (std::size_t begin = 0, end = 0; begin < grouped.size(); begin = end) {
    while (end < grouped.size() && component(grouped[end]) == component(grouped[begin])) ++end;
    solveComponent(grouped.data() + begin, grouped.data() + end, chosen);
  }
  return chosen;
}

/// Cheapest pair first. Argmin differs in that a detection has one try, with its cheapest trace.
Pairs chooseInOrder(Pairs pairs, bool oneTry, std::size_t detectionCount, std::size_t targetCount) {
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> detectionDone(detectionCount, false), targetTaken(targetCount, false);
  Pairs chosen;
  for (const auto& pair : pairs) {
    if (detectionDone[detectionOf(pair)]) continue;
    const bool taken = targetTaken[targetOf(pair)];
    if (!taken) chosen.push_back(pair);
    detectionDone[detectionOf(pair)] = oneTry || !taken;
    targetTaken[targetOf(pair)] = true;
  }
  return chosen;
}

}  // namespace

Pairs resolveConflicts(Pairs pairs, AssignmentMethod method, std::size_t detectionCount,
                       std::size_t targetCount) {
  Pairs chosen = method == AssignmentMethod::Optimal
                     ? chooseOptimally(pairs, detectionCount, targetCount)
                     : chooseInOrder(std::move(pairs), method == AssignmentMethod::Argmin,
                                     detectionCount, targetCount);
  std::sort(chosen.begin(), chosen.end(),
            [](const auto& a, const auto& b) { return a.detection < b.detection; });
  return chosen;
}

}  // namespace toss
