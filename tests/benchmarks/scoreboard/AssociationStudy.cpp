// SPDX-License-Identifier: BSD-3-Clause
#include "AssociationStudy.h"

#include <toss/evaluation/RunScores.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/HierarchicalAssociation.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "../../tracking/RandomBoxes.h"

namespace toss {
namespace {

using Pairs = std::vector<AssociationPair>;
using Method = std::function<Pairs(const AssociationProblem&)>;

Pairs hierarchical(const AssociationProblem& problem) {
  return associateHierarchically(problem, kStudyCandidates, AssignmentMethod::Optimal);
}

Pairs exhaustive(const AssociationProblem& problem) {
  return associateExhaustively(problem, AssignmentMethod::Optimal);
}

/// Problems of one size, together as many boxes at every size: solved in turn, since no scan is
/// ever seen twice and a small problem that is repeated would train the branch predictor.
std::vector<AssociationProblem> problemsOf(int size) {
  constexpr int kBoxes = 12800;
  std::mt19937 random(1);
  std::vector<AssociationProblem> problems;
  for (int boxes = 0; boxes < kBoxes; boxes += size)
    problems.push_back(randomProblem(random, size, kStudyDensity));
  return problems;
}

/// The median over at least five calls, and over as many as a tenth of a second has room for.
double medianMilliseconds(const Method& method, const std::vector<AssociationProblem>& problems) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kLeastCalls = 5, kMostCalls = 1000;
  constexpr std::chrono::milliseconds kBudget(100);
  method(problems.back());
  std::vector<double> times;
  for (const auto begin = Clock::now(); times.size() < kMostCalls;) {
    const AssociationProblem& problem = problems[times.size() % problems.size()];
    const auto start = Clock::now();
    method(problem);
    const auto end = Clock::now();
    times.push_back(std::chrono::duration<double, std::milli>(end - start).count());
    if (times.size() >= kLeastCalls && end - begin > kBudget) break;
  }
  return quantile(std::move(times), 0.5);
}

/// 25, 50, 100 ... up to `largest`.
std::vector<int> doublingSizes(int largest) {
  std::vector<int> sizes;
  for (int size = 25; size <= largest; size *= 2) sizes.push_back(size);
  return sizes;
}

/// The slope over the doubling sizes alone, which are evenly spaced.
double fittedExponent(const AssociationCurve& curve, const std::vector<int>& sizes) {
  constexpr std::size_t kPoints = 5;
  if (sizes.size() < kPoints) return std::numeric_limits<double>::quiet_NaN();
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (auto size = sizes.end() - kPoints; size != sizes.end(); ++size) {
    const double u = std::log(*size), v = std::log(curve.at(*size));
    x += u, y += v, xx += u * u, xy += u * v;
  }
  return (kPoints * xy - x * y) / (kPoints * xx - x * x);
}

AssociationCurve measure(const std::string& name, const Method& method, int largest) {
  const std::vector<int> doubling = doublingSizes(largest);
  AssociationCurve curve{name, doubling, {}, 0.0};
  std::copy_if(std::begin(kSpeedUpSizes), std::end(kSpeedUpSizes), std::back_inserter(curve.sizes),
               [&](int size) { return size < largest; });
  std::sort(curve.sizes.begin(), curve.sizes.end());
  for (const int size : curve.sizes)
    curve.milliseconds.push_back(medianMilliseconds(method, problemsOf(size)));
  curve.exponent = fittedExponent(curve, doubling);
  return curve;
}

/// 200 frames of 120 traces, as in the spec's table.
AssociationAgreement compare(double density) {
  AssociationAgreement agreement{density, 0, 0};
  std::mt19937 random(1);
  for (int frame = 0; frame < 200; ++frame) {
    const AssociationProblem problem = randomProblem(random, 120, density);
    const Pairs found = hierarchical(problem), wanted = exhaustive(problem);
    agreement.pairs += wanted.size();
    for (const AssociationPair& pair : wanted)
      if (std::any_of(found.begin(), found.end(), [&](const AssociationPair& other) {
            return other.detection == pair.detection && other.target == pair.target;
          }))
        ++agreement.equal;
  }
  return agreement;
}

}  // namespace

double AssociationCurve::at(int size) const {
  const auto found = std::find(sizes.begin(), sizes.end(), size);
  if (found == sizes.end()) return std::numeric_limits<double>::quiet_NaN();
  return milliseconds[static_cast<std::size_t>(found - sizes.begin())];
}

AssociationStudy studyAssociation() {
  constexpr int kLargest = 3200, kLargestOfAutoMos = 800;
  const std::string candidates = std::to_string(kStudyCandidates);
  AssociationStudy study;
  study.curves.push_back(measure("hierarchical, k = " + candidates, hierarchical, kLargest));
  study.curves.push_back(measure("exhaustive with gates", exhaustive, kLargest));
  study.curves.push_back(measure("Auto-MOS's matrix", associateLikeAutoMos, kLargestOfAutoMos));
  study.agreements = {compare(0.033), compare(0.133)};
  return study;
}

}  // namespace toss
