// SPDX-License-Identifier: BSD-3-Clause
#include "MapOutputs.h"

#include <toss/evaluation/MethodRun.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/rawlog/MetricMapFile.h>

#include <algorithm>
#include <sstream>

namespace toss {
namespace {

namespace fs = std::filesystem;

/// Refuses folders in which the outputs of a run would replace something else.
void checkOutput(const MapRequest& request) {
  const fs::path& out = request.output;
  std::error_code ignored;
  if (fs::equivalent(out / "filtered.rawlog", request.input, ignored))
    throw UserError(out.string(), "the input lies there and would be replaced",
                    "give another --out");
  const bool ofEarlierRun = fs::exists(out / "static_map.ply", ignored);
  if (fs::exists(out / "velodyne", ignored) ||
      (fs::exists(out / "labels", ignored) && !ofEarlierRun))
    throw UserError(out.string(), "holds labels of a dataset, which would be replaced",
                    "give another --out");
}

fs::path checkedOutput(const MapRequest& request) {
  checkOutput(request);
  return request.output;
}

std::unique_ptr<AtomicFolder> folderIf(bool wanted, const fs::path& folder) {
  return wanted ? std::make_unique<AtomicFolder>(folder) : nullptr;
}

MapPoint mapPoint(const PosedScan& scan, std::size_t i, const Eigen::Vector3d& offset) {
  const PointCloud& p = scan.points;
  const Eigen::Vector3f inMap =
      (scan.mapFromSensor * Eigen::Vector3d(p.x[i], p.y[i], p.z[i]) - offset).cast<float>();
  return {inMap.x(), inMap.y(), inMap.z(), p.intensity.empty() ? 0.0f : p.intensity[i]};
}

}  // namespace

MapOutputs::MapOutputs(const MapRequest& request, const RenderOptions& render)
    : folder_(checkedOutput(request)),
      labels_(folder_ / "labels"),
      liveLabels_(folderIf(request.liveLabels, folder_ / "live_labels")),
      instances_(folderIf(request.instances, folder_ / "instances")),
      metricMap_(folder_ / "static_map.metricmap"),
      tracks_(folder_ / "tracks.csv"),
      filtered_(folder_ / "filtered.rawlog"),
      staticSample_(static_cast<std::size_t>(render.maxPoints)),
      movingSample_(static_cast<std::size_t>(render.maxPoints)) {
  content_.name = inputName(request);
}

void MapOutputs::writeLive(const ScanLabels& labels) const {
  writeLabels(labelPath(liveLabels_->temporaryPath(), labels.scan), toFileLabels(labels));
}

void MapOutputs::writeInstances(std::uint64_t scan, const Segmentation& segmentation) const {
  writeLabels(labelPath(instances_->temporaryPath(), scan), toFileLabels(segmentation));
}

void MapOutputs::writeFinal(const ScanLabels& labels) const {
  writeLabels(labelPath(labels_.temporaryPath(), labels.scan), toFileLabels(labels));
}

void MapOutputs::addSettled(const PosedScan& scan, const ScanLabels& labels,
                            const Eigen::Vector3d& offset) {
  content_.offset = offset;
  filtered_.add(scan, labels);
  tracks_.add(labels);
  paths_[scan.sensorLabel].add(labels, offset);
  ++scansOf_[scan.sensorLabel];
  if (!shownLidar_) shownLidar_ = scan.sensorLabel;
  if (scan.sensorLabel == *shownLidar_)
    content_.trajectory.push_back(scan.mapFromSensor.translation() - offset);
  ++counts_.scans;
  counts_.points += labels.state.size();
  addMoving(scan, labels);
  for (const TrackSample& sample : labels.tracks)
    counts_.tracks = std::max<std::uint64_t>(counts_.tracks, sample.track);
}

void MapOutputs::addMoving(const PosedScan& scan, const ScanLabels& labels) {
  if (!movingPoints_)
    movingPoints_ = std::make_unique<PlyWriter>(
        folder_ / "moving_points.ply", PlyWriter::Layout::PointsWithTrack, content_.offset);
  for (std::size_t i = 0; i < labels.state.size(); ++i) {
    if (labels.state[i] == PointState::Invalid) ++counts_.invalid;
    if (labels.state[i] != PointState::Moving) continue;
    ++counts_.moving;
    const MapPoint point = mapPoint(scan, i, content_.offset);
    movingPoints_->add(point, labels.track[i]);
    movingSample_.add(point);
  }
}

void MapOutputs::addTimes(std::uint64_t scan,
                          const std::vector<std::pair<std::string, double>>& times) {
  timedScans_.push_back(scan);
  if (times_.empty())
    for (const auto& [stage, milliseconds] : times) times_.push_back({stage, {}});
  for (std::size_t s = 0; s < times.size(); ++s) times_.at(s).second.push_back(times[s].second);
}

void MapOutputs::addRest(double milliseconds) {
  const std::size_t scans = timedScans_.size();
  times_.push_back({"rest", std::vector<double>(scans, milliseconds / static_cast<double>(scans))});
}

void MapOutputs::writeTimings() const {
  std::ostringstream out;
  out << "scan";
  for (const auto& [stage, values] : times_) out << "," << stage << "_ms";
  out << "\n";
  for (std::size_t i = 0; i < timedScans_.size(); ++i) {
    out << timedScans_[i];
    for (const auto& [stage, values] : times_) out << "," << values[i];
    out << "\n";
  }
  writeTextAtomically(folder_ / "timings.csv", out.str());
}

void MapOutputs::removeEarlierRun() const {
  for (const char* name :
       {"summary.json", "resources.json", "live_labels", "instances", "snapshots"})
    fs::remove_all(folder_ / name);
}

void MapOutputs::writeStaticMap(const MultiLidarPipeline& pipeline) {
  const fs::path file = folder_ / "static_map.ply";
  staticMap_ = std::make_unique<PlyWriter>(file, PlyWriter::Layout::Points, pipeline.mapOffset());
  pipeline.visitStaticMap([&](const MapPoint& point) {
    staticMap_->add(point);
    staticSample_.add(point);
  });
  staticMap_->close();
  copyToMetricMap(staticMap_->temporaryPath(), metricMap_);
}

void MapOutputs::finish() {
  removeEarlierRun();
  counts_.mapPoints = staticMap_->count();
  staticMap_->finish();
  metricMap_.commit();
  movingPoints_->finish();
  tracks_.finish();
  filtered_.finish();
  labels_.commit();
  if (liveLabels_) liveLabels_->commit();
  if (instances_) instances_->commit();
  writeTimings();
  content_.staticPoints = staticSample_.take();
  content_.staticCount = counts_.mapPoints;
  content_.movingPoints = movingSample_.take();
  for (const auto& [label, paths] : paths_) {
    for (TrackPath& path : paths.paths()) content_.tracks.push_back(std::move(path));
    counts_.movingTracks += paths.count();
  }
  std::sort(content_.tracks.begin(), content_.tracks.end(),
            [](const TrackPath& a, const TrackPath& b) { return a.track < b.track; });
  content_.trackCount = counts_.movingTracks;
}

}  // namespace toss
