// SPDX-License-Identifier: BSD-3-Clause
#include "RunScorer.h"

#include <toss/evaluation/TrackingTruth.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/PlyFile.h>

namespace toss {

RunScorer::RunScorer(const RunFiles& files, const LabelSurvey& survey,
                     const EvaluationOptions& options)
    : files_(files),
      survey_(survey),
      options_(options),
      membership_(options, survey),
      estimates_(options.voxelSize, kScoredMaps),
      labelRemoval_(options.removalDistance, options.voxelSize) {}

void RunScorer::loadMap() {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  const std::vector<MapPoint> points = readPointCloudFile(files_.map, offset);
  const Eigen::Vector3d shift = offset - origin_;
  LabelledCloud cloud;
  for (const MapPoint& p : points) {
    cloud.add(static_cast<float>(p.x + shift.x()), static_cast<float>(p.y + shift.y()),
              static_cast<float>(p.z + shift.z()), 0);
  }
  mapPoints_ = cloud.size();
  mapTruth_ =
      std::make_unique<MapTruth>(std::move(cloud), options_.voxelSize, survey_.ignoreUnlabelled);
}

void RunScorer::readRunLabels(std::uint64_t index, std::size_t points) {
  const auto read = [&](const std::filesystem::path& folder) {
    return folder.empty() ? std::vector<std::uint32_t>()
                          : readLabels(labelPath(folder, index), points);
  };
  labels_.run = read(files_.labels);
  labels_.live = read(files_.liveLabels);
  labels_.instances = read(files_.instances);
}

void RunScorer::addScan(const PosedScan& scan, const std::vector<std::uint32_t>& truth) {
  if (scanIndices_.empty()) {
    origin_ = evaluationOrigin(scan.mapFromSensor.translation(), options_.voxelSize);
    if (!files_.map.empty()) loadMap();
  }
  scanIndices_.push_back(scan.index);
  points_ += scan.points.size();
  labels_.truth = truth;
  readRunLabels(scan.index, truth.size());
  transformScan(scan, origin_, geometry_);
  membership_.compute(geometry_, labels_);
  orderByCell(geometry_.cloud, options_.voxelSize, order_);
  estimates_.addScan(order_, membership_.facts(), membership_.membership());
  if (mapTruth_) scoreMap();
  if (!labels_.run.empty()) scoreLabels();
}

void RunScorer::scoreMap() {
  mapTruth_->addScan(order_, membership_.facts(), squaredDistanceToMap_);
  const double limit = options_.removalDistance * options_.removalDistance;
  for (std::size_t place = 0; place < order_.places(); ++place) {
    bool moving = false;
    if (!countsForRemoval(order_.index[place], moving)) continue;
    mapRemoval_.add(moving, squaredDistanceToMap_[place] <= limit);
  }
}

void RunScorer::scoreLabels() {
  moving_.addScan(labels_.truth, labels_.run, geometry_.range);
  if (!labels_.live.empty()) liveMoving_.addScan(labels_.truth, labels_.live, geometry_.range);
  tracking_.push_back(
      trackingScanFromLabels(labels_.truth, labels_.run, survey_.ignoreUnlabelled, options_));
  for (const std::uint32_t i : order_.index) {
    bool moving = false;
    if (!countsForRemoval(i, moving)) continue;
    labelRemoval_.add(geometry_.cloud.x[i], geometry_.cloud.y[i], geometry_.cloud.z[i], moving,
                      isKept(labels_.run[i]));
  }
}

bool RunScorer::countsForRemoval(std::size_t i, bool& moving) const {
  const std::uint32_t trueClass = label::semantic(labels_.truth[i]);
  const auto range = static_cast<double>(geometry_.range[i]);
  if (range > options_.removalRange || (survey_.ignoreUnlabelled && trueClass == 0)) return false;
  const bool ego = range < options_.removalEgoRange && trueClass <= 1;
  moving = ego || label::isMoving(labels_.truth[i]);
  return true;
}

void RunScorer::addScanAgain(const PosedScan& scan, const std::vector<std::uint32_t>& truth) {
  transformScan(scan, origin_, geometry_);
  labels_.run = readLabels(labelPath(files_.labels, scan.index), truth.size());
  std::vector<std::uint16_t> kept(truth.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool annotated = !survey_.ignoreUnlabelled || label::semantic(truth[i]) != 0;
    kept[i] = annotated && isKept(labels_.run[i]);
  }
  orderByCell(geometry_.cloud, options_.voxelSize, order_);
  selectMembers(order_, kept, 1, keptOrder_);
  labelRemoval_.addKept(keptOrder_);
}

}  // namespace toss
