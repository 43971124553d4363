// SPDX-License-Identifier: BSD-3-Clause
// Time per scan of the whole pipeline and of each of its stages, on simulated logs.
#include <benchmark/benchmark.h>
#include <toss/pipeline/Pipeline.h>
#include <toss/simulation/Simulator.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace toss {
namespace {

constexpr int kScans = 30;

struct Log {
  std::vector<PosedScan> scans;
  SensorModel sensor;
};

Log simulate(const std::string& scene) {
  SimulationOptions options;
  options.scene = scene;
  options.frames = kScans;
  Simulator simulator(options);
  Log log{{}, sensorByName(simulator.sensorName())};
  SimulatedScan scan;
  while (simulator.next(scan)) log.scans.push_back(scan.scan);
  return log;
}

/// One iteration is one scan; the log starts anew when it is over.
void process(benchmark::State& state, const char* scene) {
  const Log log = simulate(scene);
  std::map<std::string, double> times;
  std::unique_ptr<Pipeline> pipeline;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    if (next % log.scans.size() == 0) {
      state.PauseTiming();
      pipeline = std::make_unique<Pipeline>(PipelineOptions(), log.sensor);
      state.ResumeTiming();
    }
    pipeline->process(log.scans[next++ % log.scans.size()]);
    for (const auto& [stage, milliseconds] : pipeline->stageTimes()) times[stage] += milliseconds;
  }
  for (const auto& [stage, milliseconds] : times) {
    state.counters[stage + "_ms"] =
        benchmark::Counter(milliseconds, benchmark::Counter::kAvgIterations);
  }
}
BENCHMARK_CAPTURE(process, urban, "urban")->Unit(benchmark::kMillisecond)->Iterations(2 * kScans);
BENCHMARK_CAPTURE(process, residential, "residential")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2 * kScans);
BENCHMARK_CAPTURE(process, duckpond, "duckpond")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(2 * kScans);

}  // namespace
}  // namespace toss

BENCHMARK_MAIN();
