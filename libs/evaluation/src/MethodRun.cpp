// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/MethodRun.h>
#include <toss/pipeline/Pipeline.h>
#include <toss/rawlog/LabelFile.h>

#include <chrono>

namespace toss {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<bool> movingOf(const ScanLabels& labels) {
  std::vector<bool> moving(labels.state.size());
  for (std::size_t i = 0; i < moving.size(); ++i) moving[i] = labels.state[i] == PointState::Moving;
  return moving;
}

std::uint32_t classOf(PointState state) {
  switch (state) {
    case PointState::Invalid:
      return label::kInvalid;
    case PointState::Static:
      return label::kStatic;
    case PointState::Moving:
      return label::kMoving;
  }
  return label::kInvalid;
}

void addStages(const std::vector<std::pair<std::string, double>>& times, MethodRun& run) {
  if (run.stages.empty())
    for (const auto& [stage, milliseconds] : times) run.stages.push_back({stage, {}});
  for (std::size_t k = 0; k < times.size(); ++k) run.stages.at(k).second.push_back(times[k].second);
}

/// Shares what was left to do at the end of the log [ms] equally among the scans.
void addRest(double milliseconds, MethodRun& run) {
  const double share = milliseconds / static_cast<double>(run.milliseconds.size());
  for (double& time : run.milliseconds) time += share;
  run.stages.push_back({"rest", std::vector<double>(run.milliseconds.size(), share)});
}

void takeSettled(Pipeline& pipeline, std::size_t& settled, MethodRun& run) {
  for (ScanLabels& labels : pipeline.takeSettled()) {
    run.answers.at(settled++).final = toFileLabels(labels);
    run.tracks.push_back(std::move(labels.tracks));
  }
}

}  // namespace

std::vector<std::uint32_t> toFileLabels(const ScanLabels& labels) {
  std::vector<std::uint32_t> values(labels.state.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool valid = labels.state[i] != PointState::Invalid;
    values[i] = (valid ? toFileTrack(labels.track[i]) << 16 : 0u) | classOf(labels.state[i]);
  }
  return values;
}

std::vector<std::uint32_t> toFileLabels(const Segmentation& segmentation) {
  std::vector<std::uint32_t> values(segmentation.pointClass.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<std::uint32_t>(segmentation.instance[i]) << 16 |
                static_cast<std::uint32_t>(segmentation.pointClass[i]);
  return values;
}

MethodRun runPipeline(const LabelledLog& log, const PipelineOptions& options) {
  Pipeline pipeline(options, sensorByName(log.sensor));
  MethodRun run;
  run.answers.resize(log.scans.size());
  std::size_t settled = 0;
  for (std::size_t s = 0; s < log.scans.size(); ++s) {
    const Clock::time_point start = Clock::now();
    const ScanLabels& live = pipeline.process(log.scans[s]);
    run.milliseconds.push_back(
        std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    addStages(pipeline.stageTimes(), run);
    run.answers[s].liveMoving = movingOf(live);
    run.answers[s].instances = toFileLabels(pipeline.segmentedScan().segmentation);
    takeSettled(pipeline, settled, run);
  }
  const Clock::time_point start = Clock::now();
  pipeline.finish();
  addRest(std::chrono::duration<double, std::milli>(Clock::now() - start).count(), run);
  takeSettled(pipeline, settled, run);
  return run;
}

MethodRun keepEverything(const LabelledLog& log) {
  MethodRun run;
  for (const PosedScan& scan : log.scans) {
    run.answers.emplace_back().final.assign(scan.points.size(), label::kStatic);
    run.milliseconds.push_back(0.0);
  }
  return run;
}

}  // namespace toss
