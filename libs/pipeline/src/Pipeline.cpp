// SPDX-License-Identifier: BSD-3-Clause
#include <toss/pipeline/Pipeline.h>

#include <utility>

#include "MapCommit.h"
#include "PipelineStages.h"

namespace toss {

namespace {

std::shared_ptr<SharedMap> newMap(TileStore* tiles) {
  auto shared = std::make_shared<SharedMap>();
  shared->tiles = tiles;
  return shared;
}

}  // namespace

Pipeline::Pipeline(const PipelineOptions& options, const SensorModel& sensor, TileStore* tiles)
    : implementation_(std::make_unique<Implementation>(options, sensor, newMap(tiles))) {}

Pipeline::Pipeline(const PipelineOptions& options, const SensorModel& sensor, const Pipeline& other)
    : implementation_(
          std::make_unique<Implementation>(options, sensor, other.implementation_->shared)) {}

Pipeline::~Pipeline() = default;

const ScanLabels& Pipeline::process(const PosedScan& scan) {
  segment(scan, implementation_->first);
  return process(scan, implementation_->first);
}

void Pipeline::segment(const PosedScan& scan, FirstStages& result) {
  implementation_->segmenter.segment(scan, result.segmented);
  result.times = implementation_->segmenter.times();
}

const ScanLabels& Pipeline::process(const PosedScan& scan, FirstStages& first) {
  Implementation& stages = *implementation_;
  stages.take(first);
  stages.track(scan);
  stages.askViews(scan);
  stages.vote(scan);
  stages.labelLive();
  stages.commitComplete();
  stages.settleDue();
  return stages.live;
}

void Pipeline::skipLiveLabels() {
  implementation_->liveLabels = false;
}

void Pipeline::finish() {
  decideRest();
  for (ScanLabels labels; settleNext(labels);)
    implementation_->settled.push_back(std::exchange(labels, {}));
}

void Pipeline::decideRest() {
  implementation_->decideAll();
}

bool Pipeline::settleNext(ScanLabels& labels) {
  Implementation& stages = *implementation_;
  if (stages.records.empty()) return false;
  stages.settleFirst(labels);
  return true;
}

const SegmentedScan& Pipeline::segmentedScan() const {
  return implementation_->segmented;
}

std::vector<ScanLabels> Pipeline::takeSettled() {
  return std::exchange(implementation_->settled, {});
}

void Pipeline::Implementation::updateMap() const {
  for (std::size_t i = decided; i < committed; ++i)
    updateLedgers(records[i], judge.final(records[i], false), *shared->map);
}

const StaticMap* Pipeline::Implementation::presentMap() const {
  if (!shared->map) return nullptr;
  for (const Implementation* each : shared->pipelines) each->updateMap();
  return shared->map.get();
}

std::vector<MapPoint> Pipeline::staticMap() const {
  const StaticMap* map = implementation_->presentMap();
  return map ? map->points() : std::vector<MapPoint>();
}

void Pipeline::visitStaticMap(const std::function<void(const MapPoint&)>& visit) const {
  if (const StaticMap* map = implementation_->presentMap()) map->visitPoints(mapOffset(), visit);
}

Eigen::Vector3d Pipeline::mapOffset() const {
  return implementation_->shared->offset;
}

std::vector<MapPoint> Pipeline::pendingMap() const {
  const Implementation& stages = *implementation_;
  std::unique_ptr<StaticMap> map;
  LiveClaims claims(stages.options.decision, stages.traces);
  BoxId nextLedger = 0;
  for (std::size_t i = stages.committed; i < stages.records.size(); ++i) {
    const ScanRecord& record = stages.records[i];
    if (!map) map = makeStaticMap(stages.options.mapping, record.sensorPosition);
    const std::vector<bool> moving = stages.judge.live(record, {});
    previewScan(stages.options.mapping, moving, claims.find(record, moving), record, nextLedger,
                *map);
  }
  return map ? map->points() : std::vector<MapPoint>();
}

const std::vector<std::pair<std::string, double>>& Pipeline::stageTimes() const {
  return implementation_->clock.times();
}

}  // namespace toss
