// SPDX-License-Identifier: BSD-3-Clause
// Time per scan of each stage of segmentation, on the real sequence where it is there and on a flat
// simulated scan elsewhere.
#include <benchmark/benchmark.h>
#include <toss/segmentation/Segmenter.h>

#include "../segmentation/GroundTestScene.h"
#include "../segmentation/RealScans.h"

namespace toss::test {
namespace {

std::vector<PosedScan> loadScans() {
  std::vector<PosedScan> scans;
  if (!std::filesystem::exists(KittiSequence::folder())) {
    GroundTestScene scene;
    scene.addGround(0.0);
    scene.addBox({10, -3, 0}, {14, -1, 1.5}, GroundTestScene::Object);
    scans.push_back(scene.scan(sensorByName("HDL-64E"), sensorAt({0, 0, 1.73}), 2011).posed);
    return scans;
  }
  const KittiSequence sequence;
  for (std::size_t i = 0; i < sequence.size(); i += 10) {
    PosedScan scan;
    scan.points = sequence.points(i);
    scan.mapFromSensor = sequence.mapFromSensor(i);
    scans.push_back(std::move(scan));
  }
  return scans;
}

void segmentScans(benchmark::State& state) {
  const std::vector<PosedScan> scans = loadScans();
  ProjectionOptions projection;
  projection.egoRadius = 2.7;
  Segmenter segmenter(projection, {}, {}, sensorByName("HDL-64E"));
  SegmentedScan result;
  Segmenter::StageTimes sum;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    segmenter.segment(scans[next++ % scans.size()], result);
    sum.projection += segmenter.times().projection;
    sum.ground += segmenter.times().ground;
    sum.objects += segmenter.times().objects;
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  state.counters["projection_ms"] = benchmark::Counter(sum.projection, mean);
  state.counters["ground_ms"] = benchmark::Counter(sum.ground, mean);
  state.counters["objects_ms"] = benchmark::Counter(sum.objects, mean);
}
BENCHMARK(segmentScans)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toss::test

BENCHMARK_MAIN();
