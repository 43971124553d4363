// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/render/MapContent.h>
#include <toss/render/PointSample.h>

#include <algorithm>

namespace toss {
namespace {

namespace fs = std::filesystem;

void addBox(std::map<TrackId, TrackPath>& paths, const TrackSample& sample) {
  if (!sample.moving) return;
  TrackPath& path = paths[sample.track];
  path.track = sample.track;
  path.boxes.push_back(sample.box);
}

std::vector<TrackPath> valuesOf(const std::map<TrackId, TrackPath>& paths) {
  std::vector<TrackPath> values;
  for (const auto& entry : paths) values.push_back(entry.second);
  return values;
}

/// The points of a file less the offset of the content, which is that of the first file.
std::vector<MapPoint> readPoints(MapContent& content, const fs::path& file) {
  Eigen::Vector3d offset;
  std::vector<MapPoint> points = readPointCloudFile(file, offset);
  if (content.staticPoints.empty()) content.offset = offset;
  const Eigen::Vector3f shift = (offset - content.offset).cast<float>();
  if (!shift.isZero(0.0f))
    for (MapPoint& point : points) point.x += shift.x(), point.y += shift.y(), point.z += shift.z();
  return points;
}

void appendStatic(MapContent& content, const fs::path& file) {
  std::vector<MapPoint> points = readPoints(content, file);
  std::vector<MapPoint>& target = content.staticPoints;
  if (target.empty())
    target = std::move(points);
  else
    target.insert(target.end(), points.begin(), points.end());
}

void appendRun(MapContent& content, PointSample& moving, const fs::path& folder) {
  appendStatic(content, folder / "static_map.ply");
  if (fs::exists(folder / "moving_points.ply"))
    for (const MapPoint& point : readPoints(content, folder / "moving_points.ply"))
      moving.add(point);
  if (!fs::exists(folder / "tracks.csv")) return;
  std::map<TrackId, TrackPath> paths;
  for (TrackRow& row : readTracksCsv(folder / "tracks.csv")) {
    row.sample.box.center -= content.offset;
    addBox(paths, row.sample);
  }
  for (TrackPath& path : valuesOf(paths)) content.tracks.push_back(std::move(path));
}

std::string nameOf(const fs::path& input) {
  const fs::path plain = input.filename().empty() ? input.parent_path() : input;
  return plain.filename().string();
}

}  // namespace

void TrackPathCollector::add(const ScanLabels& labels, const Eigen::Vector3d& offset) {
  for (TrackSample sample : labels.tracks) {
    sample.box.center -= offset;
    addBox(paths_, sample);
  }
  if (paths_.size() > 2 * limit_) dropShortest(labels);
}

void TrackPathCollector::dropShortest(const ScanLabels& labels) {
  const auto isAlive = [&](TrackId track) {
    return std::any_of(labels.tracks.begin(), labels.tracks.end(),
                       [track](const TrackSample& sample) { return sample.track == track; });
  };
  std::vector<std::pair<std::size_t, TrackId>> over;
  for (const auto& [track, path] : paths_)
    if (!isAlive(track)) over.push_back({path.boxes.size(), track});
  std::sort(over.begin(), over.end());
  for (std::size_t i = 0; i + limit_ < over.size(); ++i, ++dropped_) paths_.erase(over[i].second);
}

std::vector<TrackPath> TrackPathCollector::paths() const {
  return valuesOf(paths_);
}

MapContent readMapContent(const std::vector<fs::path>& inputs, std::size_t limit) {
  MapContent content;
  PointSample moving(limit);
  for (const fs::path& input : inputs) {
    if (!content.name.empty()) content.name += " + ";
    content.name += nameOf(input);
    if (!fs::is_directory(input)) {
      appendStatic(content, input);
    } else if (fs::exists(input / "static_map.ply")) {
      appendRun(content, moving, input);
    } else {
      throw UserError(input.string(), "holds no static_map.ply",
                      "give a folder that toss map has written, or a point file");
    }
  }
  content.movingPoints = moving.points();
  return content;
}

}  // namespace toss
