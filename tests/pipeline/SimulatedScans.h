// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <toss/pipeline/Pipeline.h>
#include <toss/simulation/Simulator.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace toss::test {

/// The first scans of the simulated crossing (a car crosses, a person walks).
inline std::vector<SimulatedScan> crossingScans(int frames) {
  SimulationOptions options;
  options.scene = "crossing";
  options.frames = frames;
  options.threads = 1;
  Simulator simulator(options);
  std::vector<SimulatedScan> scans;
  SimulatedScan scan;
  while (simulator.next(scan)) scans.push_back(scan);
  return scans;
}

/// A pipeline with everything that it has answered.
struct PipelineRun {
  explicit PipelineRun(const PipelineOptions& options = {})
      : pipeline(std::make_unique<Pipeline>(options, sensorByName("VLP-16"))) {}

  void process(const PosedScan& scan) {
    live.push_back(pipeline->process(scan));
    takeSettled();
  }
  void finish() {
    pipeline->finish();
    takeSettled();
  }
  void takeSettled() {
    for (ScanLabels& labels : pipeline->takeSettled()) settled.push_back(std::move(labels));
  }

  std::unique_ptr<Pipeline> pipeline;
  /// One per scan that was processed; one per scan that is settled.
  std::vector<ScanLabels> live, settled;
};

inline PipelineRun runOf(const std::vector<SimulatedScan>& scans,
                         const PipelineOptions& options = {}) {
  PipelineRun run(options);
  for (const SimulatedScan& each : scans) run.process(each.scan);
  run.finish();
  return run;
}

inline void expectSameLabels(const std::vector<ScanLabels>& a, const std::vector<ScanLabels>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t s = 0; s < a.size(); ++s) {
    EXPECT_EQ(a[s].scan, b[s].scan);
    EXPECT_TRUE(a[s].state == b[s].state) << "scan " << s;
    EXPECT_TRUE(a[s].track == b[s].track) << "scan " << s;
  }
}

inline bool sameMap(const std::vector<MapPoint>& a, const std::vector<MapPoint>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(MapPoint)) == 0);
}

inline std::size_t countOf(const ScanLabels& labels, PointState state) {
  return static_cast<std::size_t>(std::count(labels.state.begin(), labels.state.end(), state));
}

}  // namespace toss::test
