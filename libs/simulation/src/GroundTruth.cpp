// SPDX-License-Identifier: BSD-3-Clause
#include "GroundTruth.h"

#include <algorithm>

namespace toss::simulation {

GroundTruth::GroundTruth(const World& world, double period, int frames)
    : world_(world), period_(period) {
  labels_.resize(world.stillObjects.size() + world.movers.size() + 1, 0);
  for (const auto& object : world.stillObjects) labels_[object.instance] = object.label;
  for (const Mover& mover : world.movers) {
    moves_.push_back(world.movesWithin(mover, 0.0, period, frames));
    labels_[mover.instance] = moves_.back() ? mover.figure.movingLabel : mover.figure.stillLabel;
  }
}

void GroundTruth::collect(const SweepReturns& returns, const SensorModel& sensor,
                          SimulatedScan& result) {
  counts_.assign(labels_.size(), 0);
  PointCloud& points = result.scan.points;
  points.resize(0);
  result.labels.clear();
  for (std::size_t i = 0; i < returns.beams.size(); ++i) {
    const BeamReturn& beam = returns.beams[i];
    if (beam.range <= 0.0) continue;
    const int row = static_cast<int>(i) / sensor.columns,
              column = static_cast<int>(i) % sensor.columns;
    points.x.push_back(returns.points[i].x());
    points.y.push_back(returns.points[i].y());
    points.z.push_back(returns.points[i].z());
    points.intensity.push_back(beam.intensity);
    points.ring.push_back(static_cast<std::uint16_t>(row));
    points.time.push_back(static_cast<float>(columnTime(column, sensor.columns, period_)));
    const std::uint32_t label = beam.instance ? labels_[beam.instance] : beam.label;
    result.labels.push_back(label | static_cast<std::uint32_t>(beam.instance) << 16);
    ++counts_[beam.instance];
  }
}

GroundTruthBox GroundTruth::boxOfMover(std::size_t index, double time) const {
  const Mover& mover = world_.movers[index];
  const Eigen::Isometry3d before = world_.poseOf(mover, time - 0.5 * period_);
  const Eigen::Isometry3d after = world_.poseOf(mover, time + 0.5 * period_);
  return {mover.instance,
          labels_[mover.instance],
          moves_[index],
          boxOf(mover.figure, world_.poseOf(mover, time)),
          (after.translation() - before.translation()) / period_,
          counts_[mover.instance]};
}

void GroundTruth::listBoxes(double time, std::vector<GroundTruthBox>& boxes) const {
  boxes.clear();
  for (const auto& object : world_.stillObjects) {
    boxes.push_back({object.instance, object.label, false, object.box, Eigen::Vector3d::Zero(),
                     counts_[object.instance]});
  }
  for (std::size_t i = 0; i < world_.movers.size(); ++i) boxes.push_back(boxOfMover(i, time));
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(),
                             [](const GroundTruthBox& box) { return box.points == 0; }),
              boxes.end());
  std::sort(boxes.begin(), boxes.end(),
            [](const GroundTruthBox& a, const GroundTruthBox& b) { return a.track < b.track; });
}

}  // namespace toss::simulation
