// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/Association.h>
#include <toss/tracking/AssociationCost.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/HierarchicalAssociation.h>

#include <algorithm>

namespace toss {
namespace {

bool sidesAgree(double a, double b, double minRatio) {
  return std::min(a, b) >= minRatio * std::max(a, b);
}

bool sidesAgree(const Box& a, const Box& b, double minRatio) {
  return sidesAgree(a.length, b.length, minRatio) && sidesAgree(a.width, b.width, minRatio) &&
         sidesAgree(a.height, b.height, minRatio);
}

}  // namespace

bool isAdmissible(const AssociationProblem& problem, std::int32_t detection, std::int32_t target,
                  AssociationPair& pair) {
  const Box& box = problem.detections[static_cast<std::size_t>(detection)];
  const AssociationTarget& trace = problem.targets[static_cast<std::size_t>(target)];
  const AssociationGates& gates = problem.gates;
  // Cheapest gate first: most pairs of the exhaustive method end here.
  const double squared = (box.center - trace.predicted.center).squaredNorm();
  if (!(squared <= trace.reach * trace.reach)) return false;
  if (volumeCost(box, trace.predicted) > gates.maxVolumeCost) return false;
  if (!sidesAgree(box, trace.predicted, gates.minSideRatio)) return false;
  const AssociationCost cost = associationCost(box, trace.predicted);
  if (1.0 - cost.overlap < gates.minOverlap) return false;
  pair = {detection, target, cost.total(), cost.distance};
  return true;
}

std::vector<AssociationPair> associate(const AssociationProblem& problem,
                                       const AssociationOptions& options) {
  switch (options.method) {
    case AssociationMethod::Exhaustive:
      return associateExhaustively(problem, options.assignment);
    case AssociationMethod::AutoMos:
      return associateLikeAutoMos(problem);
    case AssociationMethod::Hierarchical:
      break;
  }
  return associateHierarchically(problem, options.candidates, options.assignment);
}

}  // namespace toss
