// SPDX-License-Identifier: BSD-3-Clause
#include <toss/tracking/CandidateSearch.h>
#include <toss/tracking/ConflictResolution.h>
#include <toss/tracking/HierarchicalAssociation.h>

namespace toss {

std::vector<AssociationPair> associateHierarchically(const AssociationProblem& problem,
                                                     int candidates, AssignmentMethod assignment) {
  const CandidateSearch search(problem.targets);
  std::vector<CandidateSearch::Candidate> nearest;
  std::vector<AssociationPair> pairs;
  AssociationPair pair;
  for (std::size_t i = 0; i < problem.detections.size(); ++i) {
    search.nearest(problem.detections[i].center, candidates, nearest);
    for (const auto& candidate : nearest) {
      if (isAdmissible(problem, static_cast<std::int32_t>(i), candidate.target, pair)) {
        pairs.push_back(pair);
      }
    }
  }
  return resolveConflicts(std::move(pairs), assignment, problem.detections.size(),
                          problem.targets.size());
}

}  // namespace toss
