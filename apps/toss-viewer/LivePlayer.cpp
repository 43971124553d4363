// SPDX-License-Identifier: BSD-3-Clause
#include "LivePlayer.h"

#include <chrono>

#include "SensorOfInput.h"

namespace toss {
namespace {

/// staticMap() lacks the last seconds, which are what one looks at.
std::shared_ptr<const std::vector<MapPoint>> presentMap(const Pipeline& pipeline) {
  auto map = std::make_shared<std::vector<MapPoint>>(pipeline.staticMap());
  const std::vector<MapPoint> pending = pipeline.pendingMap();
  map->insert(map->end(), pending.begin(), pending.end());
  return map;
}

}  // namespace

LivePlayer::LivePlayer(const PlayRequest& request)
    : name_(request.input.filename().string()), mapPeriod_(request.mapPeriod) {
  RunConfiguration configuration = configure(request.configuration, "");
  const SensorChoice sensor = sensorOfInput(request.input, configuration, request.from, request.to);
  configuration = configure(request.configuration, sensor.preset);
  scans_ =
      std::make_unique<ScanRange>(request.input, configuration.input, request.from, request.to);
  pipeline_ = std::make_unique<Pipeline>(configuration.pipeline, sensor.model);
}

bool LivePlayer::next(LiveFrame& frame) {
  if (!scans_->next(scan_)) return false;
  const auto start = std::chrono::steady_clock::now();
  const ScanLabels& labels = pipeline_->process(scan_);
  pipeline_->takeSettled();
  const std::chrono::duration<double, std::milli> duration =
      std::chrono::steady_clock::now() - start;
  if (count_ == 0) firstTime_ = scan_.time;
  frame.scan = scan_.index;
  frame.time = scan_.time - firstTime_;
  frame.mapFromSensor = scan_.mapFromSensor;
  frame.milliseconds = duration.count();
  frame.traces = watch_.update(labels);
  frame.flips = watch_.flips();
  frame.trajectory.push_back(scan_.mapFromSensor.translation());
  show(labels, frame);
  if (!frame.map || count_ % static_cast<std::uint64_t>(mapPeriod_) == 0)
    frame.map = presentMap(*pipeline_);
  ++count_;
  return true;
}

void LivePlayer::show(const ScanLabels& labels, LiveFrame& frame) const {
  const std::vector<PointClass>& pointClass = pipeline_->segmentedScan().segmentation.pointClass;
  const PointCloud& points = scan_.points;
  for (auto* layer : {&frame.ground, &frame.standing, &frame.moving}) layer->clear();
  for (std::size_t i = 0; i < labels.state.size(); ++i) {
    if (labels.state[i] == PointState::Invalid) continue;
    const Eigen::Vector3d inSensor(points.x[i], points.y[i], points.z[i]);
    const Eigen::Vector3f p = (scan_.mapFromSensor * inSensor).cast<float>();
    const MapPoint point{p.x(), p.y(), p.z(),
                         points.intensity.empty() ? 0.0f : points.intensity[i]};
    const bool isGround = pointClass[i] == PointClass::Ground;
    auto& layer = labels.state[i] == PointState::Moving ? frame.moving
                  : isGround                            ? frame.ground
                                                        : frame.standing;
    layer.push_back(point);
  }
}

}  // namespace toss
