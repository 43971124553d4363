// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <toss/tracking/AssociationCost.h>
#include <toss/tracking/CandidateSearch.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/HierarchicalAssociation.h>

#include <algorithm>
#include <set>

#include "RandomBoxes.h"

namespace toss {
namespace {

using Pairs = std::vector<AssociationPair>;
constexpr int kAll = 1000000;

std::set<std::pair<int, int>> namesOf(const Pairs& pairs) {
  std::set<std::pair<int, int>> names;
  for (const auto& pair : pairs) names.insert({pair.detection, pair.target});
  return names;
}

double totalCost(const Pairs& pairs) {
  double total = 0.0;
  for (const auto& pair : pairs) total += pair.cost;
  return total;
}

void expectValid(const AssociationProblem& problem, const Pairs& pairs) {
  std::set<int> detections, targets;
  AssociationPair check;
  for (const auto& pair : pairs) {
    EXPECT_TRUE(detections.insert(pair.detection).second);
    EXPECT_TRUE(targets.insert(pair.target).second);
    EXPECT_TRUE(isAdmissible(problem, pair.detection, pair.target, check));
  }
}

Box cube(double x, double side = 1.0) {
  Box box;
  box.center.x() = x;
  box.length = box.width = box.height = side;
  return box;
}

TEST(AssociationCost, HasThePapersThreeTerms) {
  Box small = cube(0.5);
  small.height = 0.5;
  const AssociationCost cost = associationCost(cube(0.0), small);
  EXPECT_DOUBLE_EQ(cost.distance, 0.5);
  EXPECT_NEAR(cost.overlap, 1.0 - 0.25 / (1.0 + 0.5 - 0.25), 1e-12);
  EXPECT_DOUBLE_EQ(cost.volume, 0.5);
  EXPECT_DOUBLE_EQ(cost.total(), cost.distance + cost.overlap + cost.volume);
  EXPECT_EQ(volumeCost(cube(0, 0.0), cube(0, 0.0)), 0.0);
  EXPECT_EQ(volumeCost(cube(0, 0.0), cube(0)), 1.0);
}

TEST(HierarchicalAssociation, WithAllCandidatesEqualsTheExhaustiveGatedOptimum) {
  std::mt19937 random(29);
  for (const double density : {0.033, 0.133, 0.53}) {
    for (int frame = 0; frame < 30; ++frame) {
      const AssociationProblem problem = randomProblem(random, 120, density);
      const Pairs hierarchical = associateHierarchically(problem, kAll, AssignmentMethod::Optimal);
      const Pairs exhaustive = associateExhaustively(problem, AssignmentMethod::Optimal);
      expectValid(problem, hierarchical);
      EXPECT_EQ(namesOf(hierarchical), namesOf(exhaustive)) << density << ", frame " << frame;
    }
  }
}

TEST(HierarchicalAssociation, WithTiesIsAsGoodAsTheExhaustiveOptimum) {
  std::mt19937 random(31);
  std::uniform_int_distribution<int> place(0, 6);
  for (int frame = 0; frame < 200; ++frame) {
    AssociationProblem problem;
    problem.gates = usualGates();
    for (int i = 0; i < 8; ++i) {
      problem.targets.push_back({cube(0.5 * place(random)), 2.0});
      problem.detections.push_back(cube(0.5 * place(random)));
    }
    const Pairs hierarchical = associateHierarchically(problem, kAll, AssignmentMethod::Optimal);
    const Pairs exhaustive = associateExhaustively(problem, AssignmentMethod::Optimal);
    expectValid(problem, hierarchical);
    EXPECT_EQ(hierarchical.size(), exhaustive.size());
    EXPECT_NEAR(totalCost(hierarchical), totalCost(exhaustive), 1e-9);
  }
}

TEST(HierarchicalAssociation, FiveCandidatesLoseNothingAtTheDensitiesOfRoads) {
  std::mt19937 random(37);
  std::size_t equal = 0, all = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const AssociationProblem problem = randomProblem(random, 120, frame % 2 == 0 ? 0.033 : 0.133);
    const auto few = namesOf(associateHierarchically(problem, 5, AssignmentMethod::Optimal));
    const auto full = namesOf(associateExhaustively(problem, AssignmentMethod::Optimal));
    all += full.size();
    for (const auto& pair : full) equal += few.count(pair);
  }
  EXPECT_GE(static_cast<double>(equal), 0.999 * static_cast<double>(all));
  RecordProperty("equal_matches", static_cast<int>(equal));
  RecordProperty("all_matches", static_cast<int>(all));
}

TEST(HierarchicalAssociation, GreedyAndArgminDoNotDependOnTheSearchEither) {
  std::mt19937 random(41);
  for (const auto method : {AssignmentMethod::Greedy, AssignmentMethod::Argmin}) {
    for (int frame = 0; frame < 30; ++frame) {
      const AssociationProblem problem = randomProblem(random, 120, 0.3);
      const Pairs pairs = associateHierarchically(problem, kAll, method);
      expectValid(problem, pairs);
      EXPECT_EQ(namesOf(pairs), namesOf(associateExhaustively(problem, method)));
    }
  }
}

/// Two boxes want trace 0; one of them could also have trace 1.
AssociationProblem contestedProblem() {
  AssociationProblem problem;
  problem.gates = usualGates();
  problem.targets = {{cube(0.0), 2.0}, {cube(0.8), 2.0}};
  problem.detections = {cube(0.1), cube(-0.3)};
  return problem;
}

TEST(Assignment, MethodsDifferWhereBoxesContest) {
  const AssociationProblem problem = contestedProblem();
  EXPECT_EQ(namesOf(associateHierarchically(problem, 5, AssignmentMethod::Optimal)),
            (std::set<std::pair<int, int>>{{0, 1}, {1, 0}}));
  EXPECT_EQ(namesOf(associateHierarchically(problem, 5, AssignmentMethod::Greedy)),
            (std::set<std::pair<int, int>>{{0, 0}}));
  EXPECT_EQ(namesOf(associateHierarchically(problem, 5, AssignmentMethod::Argmin)),
            (std::set<std::pair<int, int>>{{0, 0}}));
}

TEST(ExhaustiveAssociation, BigNumbersForViolatedGatesLosePairsThatTheGatedOptimumKeeps) {
  std::mt19937 random(43);
  std::size_t lost = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const AssociationProblem dense = randomProblem(random, 120, 0.53);
    const Pairs big = associateLikeAutoMos(dense);
    const Pairs optimum = associateExhaustively(dense, AssignmentMethod::Optimal);
    expectValid(dense, big);
    EXPECT_LE(big.size(), optimum.size());
    lost += optimum.size() - big.size();
  }
  EXPECT_GT(lost, 0u);
}

TEST(CandidateSearch, FindsWhatATestOfEveryTraceFinds) {
  std::mt19937 random(47);
  std::uniform_real_distribution<double> reach(0.5, 5.0), place(-60.0, 60.0);
  std::vector<AssociationTarget> targets;
  for (int i = 0; i < 300; ++i) {
    AssociationTarget target{randomBox(random, 100.0), reach(random)};
    target.predicted.center -= Eigen::Vector3d(50.0, 50.0, 0.0);
    targets.push_back(target);
  }
  targets.push_back(targets.front());
  const CandidateSearch search(targets);
  std::vector<CandidateSearch::Candidate> found;
  for (int query = 0; query < 500; ++query) {
    const Eigen::Vector3d point(place(random), place(random), 0.1);
    std::vector<CandidateSearch::Candidate> expected;
    for (std::size_t j = 0; j < targets.size(); ++j) {
      const double distance = (targets[j].predicted.center - point).norm();
      if (distance <= targets[j].reach) {
        expected.push_back({distance, static_cast<std::int32_t>(j)});
      }
    }
    std::sort(expected.begin(), expected.end());
    expected.resize(std::min<std::size_t>(expected.size(), 4));
    search.nearest(point, 4, found);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].target, expected[i].target);
  }
}

TEST(CandidateSearch, TakesNoTracesAndPlacesBeyondTheGrid) {
  std::vector<CandidateSearch::Candidate> found;
  const std::vector<AssociationTarget> none;
  CandidateSearch(none).nearest({0, 0, 0}, 5, found);
  EXPECT_TRUE(found.empty());
  const std::vector<AssociationTarget> far = {{cube(1e300), 2.0}};
  CandidateSearch(far).nearest({1e300, 0, 0}, 5, found);
  EXPECT_EQ(found.size(), 1u);
}

}  // namespace
}  // namespace toss
