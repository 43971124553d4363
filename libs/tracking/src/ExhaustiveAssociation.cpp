// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/AssociationCost.h>
#include <toss/tracking/ConflictResolution.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/OptimalAssignment.h>

#include <limits>

namespace toss {
namespace {

using Pairs = std::vector<AssociationPair>;

constexpr double kViolation = 1e8;

template <typename Visit>
void visitAdmissible(const AssociationProblem& problem, const Visit& visit) {
  AssociationPair pair;
  for (std::size_t i = 0; i < problem.detections.size(); ++i) {
    for (std::size_t j = 0; j < problem.targets.size(); ++j) {
      if (isAdmissible(problem, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), pair)) {
        visit(pair);
      }
    }
  }
}

CostMatrix emptyMatrix(const AssociationProblem& problem, double fill) {
  return {static_cast<int>(problem.detections.size()), static_cast<int>(problem.targets.size()),
          fill};
}

double costLikeAutoMos(const AssociationProblem& problem, std::size_t detection,
                       std::size_t target) {
  const AssociationTarget& trace = problem.targets[target];
  const AssociationCost cost = associationCost(problem.detections[detection], trace.predicted);
  return (cost.distance <= trace.reach ? cost.distance : kViolation) +
         (1.0 - cost.overlap >= problem.gates.minOverlap ? cost.overlap : kViolation) +
         (cost.volume <= problem.gates.maxVolumeCost ? cost.volume : kViolation);
}

/// The chosen entries that cost less than `limit`.
Pairs pairsOf(const AssociationProblem& problem, const CostMatrix& matrix,
              const std::vector<std::int32_t>& columnOfRow, double limit) {
  Pairs chosen;
  for (std::int32_t row = 0; row < matrix.rows; ++row) {
    const std::int32_t column = columnOfRow[static_cast<std::size_t>(row)];
    if (column < 0 || !(matrix.at(row, column) < limit)) continue;
    const auto& center = problem.detections[static_cast<std::size_t>(row)].center;
    const auto& predicted = problem.targets[static_cast<std::size_t>(column)].predicted.center;
    chosen.push_back({row, column, matrix.at(row, column), (center - predicted).norm()});
  }
  return chosen;
}

}  // namespace

Pairs associateExhaustively(const AssociationProblem& problem, AssignmentMethod assignment) {
  constexpr double kForbidden = std::numeric_limits<double>::infinity();
  if (assignment != AssignmentMethod::Optimal) {
    Pairs pairs;
    visitAdmissible(problem, [&](const AssociationPair& pair) { pairs.push_back(pair); });
    return resolveConflicts(std::move(pairs), assignment, problem.detections.size(),
                            problem.targets.size());
  }
  CostMatrix matrix = emptyMatrix(problem, kForbidden);
  visitAdmissible(problem, [&](const AssociationPair& pair) {
    matrix.at(pair.detection, pair.target) = pair.cost;
  });
  return pairsOf(problem, matrix, solveGatedAssignment(matrix), kForbidden);
}

Pairs associateLikeAutoMos(const AssociationProblem& problem) {
  CostMatrix matrix = emptyMatrix(problem, 0.0);
  for (int row = 0; row < matrix.rows; ++row) {
    for (int column = 0; column < matrix.columns; ++column) {
      matrix.at(row, column) =
          costLikeAutoMos(problem, static_cast<std::size_t>(row), static_cast<std::size_t>(column));
    }
  }
  return pairsOf(problem, matrix, solveAssignment(matrix), kViolation);
}

}  // namespace toss
