// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/HierarchicalAssociation.h>

#include "../tracking/RandomBoxes.h"

namespace toss {
namespace {

/// Traces per square metre of a town as the real scans show it.
constexpr double kDensity = 0.033;

AssociationProblem problemOf(const benchmark::State& state) {
  std::mt19937 random(1);
  return randomProblem(random, static_cast<int>(state.range(0)), kDensity);
}

template <int kLargest>
void sizes(benchmark::internal::Benchmark* benchmark) {
  for (int boxes = 25; boxes <= kLargest; boxes *= 2) benchmark->Arg(boxes);
}

/// The paper's method, k = 5.
void hierarchical(benchmark::State& state) {
  const AssociationProblem problem = problemOf(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(associateHierarchically(problem, 5, AssignmentMethod::Optimal));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(hierarchical)->Apply(sizes<3200>)->Complexity();

/// The full matrix with the same gates, solved as a whole: the fair baseline.
void exhaustive(benchmark::State& state) {
  const AssociationProblem problem = problemOf(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(associateExhaustively(problem, AssignmentMethod::Optimal));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(exhaustive)->Apply(sizes<3200>)->Complexity();

/// Auto-MOS's matrix, where every pair costs all three terms.
void autoMos(benchmark::State& state) {
  const AssociationProblem problem = problemOf(state);
  for (auto _ : state) benchmark::DoNotOptimize(associateLikeAutoMos(problem));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(autoMos)->Apply(sizes<800>)->Complexity();

}  // namespace
}  // namespace toss

BENCHMARK_MAIN();
