// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <toss/tracking/ExhaustiveAssociation.h>
#include <toss/tracking/HierarchicalAssociation.h>

#include "../tracking/RandomBoxes.h"

namespace toss {
namespace {

/// Traces per square metre of a town as the real scans show it.
constexpr double kDensity = 0.033;

/// Problems of one size that are solved in turn, together as many boxes at every size: no scan is
/// ever seen twice, and a small problem that is repeated would train the branch predictor.
class Problems {
 public:
  explicit Problems(const benchmark::State& state) {
    constexpr int kBoxes = 12800;
    std::mt19937 random(1);
    const int size = static_cast<int>(state.range(0));
    for (int i = 0; i < kBoxes; i += size)
      problems_.push_back(randomProblem(random, size, kDensity));
  }
  const AssociationProblem& next() { return problems_[next_++ % problems_.size()]; }

 private:
  std::vector<AssociationProblem> problems_;
  std::size_t next_ = 0;
};

template <int kLargest>
void sizes(benchmark::internal::Benchmark* benchmark) {
  for (int boxes = 25; boxes <= kLargest; boxes *= 2) benchmark->Arg(boxes);
}

/// The paper's method, k = 5.
void hierarchical(benchmark::State& state) {
  Problems problems(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        associateHierarchically(problems.next(), 5, AssignmentMethod::Optimal));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(hierarchical)->Apply(sizes<3200>)->Complexity();

/// The full matrix with the same gates, solved as a whole: the fair baseline.
void exhaustive(benchmark::State& state) {
  Problems problems(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(associateExhaustively(problems.next(), AssignmentMethod::Optimal));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(exhaustive)->Apply(sizes<3200>)->Complexity();

/// Auto-MOS's matrix, where every pair costs all three terms.
void autoMos(benchmark::State& state) {
  Problems problems(state);
  for (auto _ : state) benchmark::DoNotOptimize(associateLikeAutoMos(problems.next()));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(autoMos)->Apply(sizes<800>)->Complexity();

}  // namespace
}  // namespace toss

BENCHMARK_MAIN();
