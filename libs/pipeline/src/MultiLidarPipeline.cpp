// SPDX-License-Identifier: BSD-3-Clause
#include <toss/pipeline/MultiLidarPipeline.h>

#include <stdexcept>

namespace toss {
namespace {

/// A LiDAR without scans for this long [s] does not hold up the labels of the others any more.
constexpr double kLongestSilence = 60.0;

}  // namespace

const Pipeline* MultiLidarPipeline::any() const {
  return lidars_.empty() ? nullptr : lidars_.begin()->second.pipeline.get();
}

void MultiLidarPipeline::add(const std::string& label, PipelineOptions options,
                             const SensorModel& sensor) {
  if (has(label)) throw std::logic_error("MultiLidarPipeline::add: the label is there already");
  if (const Pipeline* first = any()) {
    options.mapping = mapping_;
    lidars_[label].pipeline = std::make_unique<Pipeline>(options, sensor, *first);
  } else {
    mapping_ = options.mapping;
    lidars_[label].pipeline = std::make_unique<Pipeline>(options, sensor, tiles_);
  }
}

MultiLidarPipeline::Lidar& MultiLidarPipeline::lidarOf(const PosedScan& scan) {
  const auto found = lidars_.size() == 1 ? lidars_.begin() : lidars_.find(scan.sensorLabel);
  if (found == lidars_.end())
    throw std::logic_error("MultiLidarPipeline: no LiDAR has the label of the scan");
  return found->second;
}

void MultiLidarPipeline::segment(const PosedScan& scan, FirstStages& result) {
  lidarOf(scan).pipeline->segment(scan, result);
}

const ScanLabels& MultiLidarPipeline::process(const PosedScan& scan) {
  segment(scan, first_);
  return process(scan, first_);
}

const ScanLabels& MultiLidarPipeline::process(const PosedScan& scan, FirstStages& first) {
  last_ = &lidarOf(scan);
  order_.push_back(last_);
  last_->lastTime = scan.time;
  ++last_->open;
  const ScanLabels& live = last_->pipeline->process(scan, first);
  gather(*last_);
  if (lidars_.size() > 1) settleSilent(scan.time);
  return live;
}

void MultiLidarPipeline::skipLiveLabels() {
  for (auto& [label, lidar] : lidars_) lidar.pipeline->skipLiveLabels();
}

void MultiLidarPipeline::gather(Lidar& lidar) {
  for (ScanLabels& labels : lidar.pipeline->takeSettled()) {
    lidar.settled.push_back(std::move(labels));
    --lidar.open;
  }
}

void MultiLidarPipeline::settleSilent(double now) {
  for (auto& [label, lidar] : lidars_) {
    if (lidar.open == 0 || now - lidar.lastTime <= kLongestSilence) continue;
    lidar.pipeline->finish();
    gather(lidar);
  }
}

std::vector<ScanLabels> MultiLidarPipeline::takeSettled() {
  std::vector<ScanLabels> result;
  while (!order_.empty() && !order_.front()->settled.empty()) {
    result.push_back(std::move(order_.front()->settled.front()));
    order_.front()->settled.pop_front();
    order_.pop_front();
  }
  return result;
}

void MultiLidarPipeline::finish() {
  for (auto& [label, lidar] : lidars_) {
    lidar.pipeline->finish();
    gather(lidar);
  }
}

void MultiLidarPipeline::decideRest() {
  for (auto& [label, lidar] : lidars_) lidar.pipeline->decideRest();
}

bool MultiLidarPipeline::settleNext(ScanLabels& labels) {
  if (order_.empty()) return false;
  Lidar& lidar = *order_.front();
  order_.pop_front();
  if (lidar.settled.empty()) return lidar.pipeline->settleNext(labels);
  labels = std::move(lidar.settled.front());
  lidar.settled.pop_front();
  return true;
}

std::vector<MapPoint> MultiLidarPipeline::staticMap() const {
  return any() ? any()->staticMap() : std::vector<MapPoint>();
}

void MultiLidarPipeline::visitStaticMap(const std::function<void(const MapPoint&)>& visit) const {
  if (any()) any()->visitStaticMap(visit);
}

Eigen::Vector3d MultiLidarPipeline::mapOffset() const {
  return any() ? any()->mapOffset() : Eigen::Vector3d::Zero();
}

std::vector<MapPoint> MultiLidarPipeline::pendingMap() const {
  std::vector<MapPoint> result;
  for (const auto& [label, lidar] : lidars_) {
    const std::vector<MapPoint> pending = lidar.pipeline->pendingMap();
    result.insert(result.end(), pending.begin(), pending.end());
  }
  return result;
}

}  // namespace toss
