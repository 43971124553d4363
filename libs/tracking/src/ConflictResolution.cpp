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
std::vector<std::int32_t> distinct(const Pairs& pairs, Member member) {
  std::vector<std::int32_t> values;
  for (const auto& pair : pairs) values.push_back(pair.*member);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

int positionIn(const std::vector<std::int32_t>& values, std::int32_t value) {
  return static_cast<int>(std::lower_bound(values.begin(), values.end(), value) - values.begin());
}

/// Cheapest pair of several of one detection or of one target, as solveComponent would choose.
const AssociationPair& cheapest(const Pairs& pairs) {
  return *std::min_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return std::tie(a.cost, a.detection, a.target) < std::tie(b.cost, b.detection, b.target);
  });
}

void solveComponent(const Pairs& pairs, Pairs& chosen) {
  const auto detections = distinct(pairs, &AssociationPair::detection);
  const auto targets = distinct(pairs, &AssociationPair::target);
  if (detections.size() == 1 || targets.size() == 1) return chosen.push_back(cheapest(pairs));
  CostMatrix matrix(static_cast<int>(detections.size()), static_cast<int>(targets.size()),
                    std::numeric_limits<double>::infinity());
  for (const auto& pair : pairs) {
    matrix.at(positionIn(detections, pair.detection), positionIn(targets, pair.target)) = pair.cost;
  }
  const auto columnOfRow = solveGatedAssignment(matrix);
  for (const auto& pair : pairs) {
    const auto row = static_cast<std::size_t>(positionIn(detections, pair.detection));
    if (columnOfRow[row] == positionIn(targets, pair.target)) chosen.push_back(pair);
  }
}

/// Pairs that share neither their detection nor their target with another are chosen at once; the
/// others come back in `contested`.
Pairs chooseUncontested(const Pairs& pairs, std::size_t detectionCount, std::size_t targetCount,
                        Pairs& contested) {
  std::vector<std::int32_t> ofDetection(detectionCount, 0), ofTarget(targetCount, 0);
  for (const auto& pair : pairs) ++ofDetection[detectionOf(pair)], ++ofTarget[targetOf(pair)];
  Pairs chosen;
  chosen.reserve(std::min(detectionCount, targetCount));
  for (const auto& pair : pairs) {
    const bool alone = ofDetection[detectionOf(pair)] == 1 && ofTarget[targetOf(pair)] == 1;
    (alone ? chosen : contested).push_back(pair);
  }
  return chosen;
}

Pairs chooseOptimally(const Pairs& pairs, std::size_t detectionCount, std::size_t targetCount) {
  constexpr std::size_t kEnd = static_cast<std::size_t>(-1);
  Pairs contested;
  Pairs chosen = chooseUncontested(pairs, detectionCount, targetCount, contested);
  ConnectedComponents components(detectionCount + targetCount);
  for (const auto& pair : contested) {
    components.join(detectionOf(pair), detectionCount + targetOf(pair));
  }
  // The smallest member of a component is a detection: each has a list of its component's pairs.
  std::vector<std::size_t> first(detectionCount, kEnd), next(contested.size());
  for (std::size_t i = contested.size(); i-- > 0;) {
    std::size_t& head = first[components.find(detectionOf(contested[i]))];
    next[i] = head, head = i;
  }
  Pairs component;
  for (const std::size_t head : first) {
    if (head == kEnd) continue;
    component.clear();
    for (std::size_t i = head; i != kEnd; i = next[i]) component.push_back(contested[i]);
    solveComponent(component, chosen);
  }
  return chosen;
}

/// The same pairs by ascending detection, of which each has at most one.
Pairs byDetection(const Pairs& pairs, std::size_t detectionCount) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> pairOf(detectionCount, kNone);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairOf[detectionOf(pairs[i])] = i;
  Pairs ordered;
  ordered.reserve(pairs.size());
  for (const std::size_t i : pairOf)
    if (i != kNone) ordered.push_back(pairs[i]);
  return ordered;
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
  return byDetection(chosen, detectionCount);
}

}  // namespace toss
