// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/PlyFile.h>
#include <toss/rawlog/TracksCsv.h>
#include <toss/render/MapContent.h>
#include <toss/render/PointSample.h>

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

void appendPoints(std::vector<MapPoint>& target, const fs::path& file) {
  std::vector<MapPoint> points = readPointCloudFile(file);
  if (target.empty())
    target = std::move(points);
  else
    target.insert(target.end(), points.begin(), points.end());
}

void appendRun(MapContent& content, PointSample& moving, const fs::path& folder) {
  appendPoints(content.staticPoints, folder / "static_map.ply");
  if (fs::exists(folder / "moving_points.ply"))
    for (const MapPoint& point : readPointCloudFile(folder / "moving_points.ply"))
      moving.add(point);
  if (!fs::exists(folder / "tracks.csv")) return;
  std::map<TrackId, TrackPath> paths;
  for (const TrackRow& row : readTracksCsv(folder / "tracks.csv")) addBox(paths, row.sample);
  for (TrackPath& path : valuesOf(paths)) content.tracks.push_back(std::move(path));
}

std::string nameOf(const fs::path& input) {
  const fs::path plain = input.filename().empty() ? input.parent_path() : input;
  return plain.filename().string();
}

}  // namespace

void TrackPathCollector::add(const ScanLabels& labels) {
  for (const TrackSample& sample : labels.tracks) addBox(paths_, sample);
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
      appendPoints(content.staticPoints, input);
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
