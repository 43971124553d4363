// SPDX-License-Identifier: BSD-3-Clause
#include <toss/pipeline/Pipeline.h>

#include <utility>

#include "MapCommit.h"
#include "PipelineStages.h"

namespace toss {

Pipeline::Pipeline(const PipelineOptions& options, const SensorModel& sensor)
    : implementation_(std::make_unique<Implementation>(options, sensor)) {}

Pipeline::~Pipeline() = default;

const ScanLabels& Pipeline::process(const PosedScan& scan) {
  Implementation& stages = *implementation_;
  stages.clock.restart();
  stages.segment(scan);
  stages.track(scan);
  stages.askViews(scan);
  stages.vote(scan);
  stages.labelLive();
  stages.commitComplete(false);
  stages.settle(false);
  return stages.live;
}

void Pipeline::finish() {
  implementation_->commitComplete(true);
  implementation_->settle(true);
}

const SegmentedScan& Pipeline::segmentedScan() const {
  return implementation_->segmented;
}

std::vector<ScanLabels> Pipeline::takeSettled() {
  return std::exchange(implementation_->settled, {});
}

std::vector<MapPoint> Pipeline::staticMap() const {
  const Implementation& stages = *implementation_;
  if (!stages.map) return {};
  for (std::size_t i = 0; i < stages.committed; ++i)
    updateLedgers(stages.records[i], stages.judge.final(stages.records[i], false), *stages.map);
  return stages.map->points();
}

std::vector<MapPoint> Pipeline::pendingMap() const {
  const Implementation& stages = *implementation_;
  std::unique_ptr<StaticMap> map;
  for (std::size_t i = stages.committed; i < stages.records.size(); ++i) {
    const ScanRecord& record = stages.records[i];
    if (!map) map = makeStaticMap(stages.options.mapping, record.sensorPosition);
    previewScan(stages.options.mapping, stages.judge.live(record, {}), record, *map);
  }
  return map ? map->points() : std::vector<MapPoint>();
}

const std::vector<std::pair<std::string, double>>& Pipeline::stageTimes() const {
  return implementation_->clock.times();
}

}  // namespace toss
