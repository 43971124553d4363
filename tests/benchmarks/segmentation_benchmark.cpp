// SPDX-License-Identifier: BSD-3-Clause
// Time per scan of each stage from the projection to the boxes, on the real sequence where it is
// there and on a flat simulated scan elsewhere.
#include <benchmark/benchmark.h>
#include <toss/segmentation/Segmenter.h>
#include <toss/tracking/BoundingBoxes.h>

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

Segmenter makeSegmenter() {
  ProjectionOptions projection;
  projection.egoRadius = 2.7;
  return Segmenter(projection, {}, {}, sensorByName("HDL-64E"));
}

/// Runs the whole segmentation, as each stage needs those before it, and counts the time of one.
void segmentation(benchmark::State& state, double Segmenter::StageTimes::*stage) {
  const std::vector<PosedScan> scans = loadScans();
  Segmenter segmenter = makeSegmenter();
  SegmentedScan result;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    segmenter.segment(scans[next++ % scans.size()], result);
    state.SetIterationTime(segmenter.times().*stage * 1e-3);
  }
}
BENCHMARK_CAPTURE(segmentation, projection, &Segmenter::StageTimes::projection)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(segmentation, ground, &Segmenter::StageTimes::ground)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(segmentation, objects, &Segmenter::StageTimes::objects)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void boxes(benchmark::State& state, BoxMode mode) {
  const std::vector<PosedScan> scans = loadScans();
  Segmenter segmenter = makeSegmenter();
  std::vector<SegmentedScan> segmented(scans.size());
  for (std::size_t i = 0; i < scans.size(); ++i) segmenter.segment(scans[i], segmented[i]);
  BoxOptions options;
  options.mode = mode;
  std::vector<Detection> detections;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const SegmentedScan& scan = segmented[next++ % scans.size()];
    detectInstances(scan.level, scan.segmentation, Eigen::Vector3d::Zero(), options, detections);
    benchmark::DoNotOptimize(detections.data());
  }
}
BENCHMARK_CAPTURE(boxes, aabb, BoxMode::AxisAligned)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(boxes, lshape, BoxMode::LShape)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace toss::test

BENCHMARK_MAIN();
