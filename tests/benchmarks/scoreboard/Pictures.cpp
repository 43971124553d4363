// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include <toss/rawlog/LabelFile.h>
#include <toss/render/PointSample.h>
#include <toss/render/RenderUnavailable.h>
#include <toss/render/Snapshots.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace toss {
namespace {

constexpr std::size_t kPointsPerPicture = 1500000;

/// Pictures of the sheets are small; their sheet makes them smaller still.
RenderOptions cellOptions() {
  RenderOptions options;
  options.width = 1280, options.height = 800, options.color = PictureColor::Class;
  return options;
}

/// Place of the name among the names, -1 where it is none of them.
int placeAmong(const std::vector<const char*>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// The returns of a log, parted by labels of the same shape as its own; 0 is left out.
MapContent contentOf(const LabelledLog& log,
                     const std::function<const std::vector<std::uint32_t>&(std::size_t)>& labels) {
  PointSample still(kPointsPerPicture), moving(kPointsPerPicture);
  for (std::size_t s = 0; s < log.scans.size(); ++s) {
    const PosedScan& scan = log.scans[s];
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const Eigen::Vector3d inSensor(scan.points.x[i], scan.points.y[i], scan.points.z[i]);
      if (!std::isfinite(inSensor.squaredNorm()) || label::semantic(labels(s)[i]) == 0) continue;
      const Eigen::Vector3f p = (scan.mapFromSensor * inSensor).cast<float>();
      (label::isMoving(labels(s)[i]) ? moving : still).add({p.x(), p.y(), p.z(), 0.0f});
    }
  }
  MapContent content;
  content.name = log.name;
  content.staticPoints = still.points(), content.movingPoints = moving.points();
  for (const PosedScan& scan : log.scans)
    content.trajectory.push_back(scan.mapFromSensor.translation());
  return content;
}

std::vector<TrackPath> movingPaths(const MethodRun& run) {
  TrackPathCollector paths;
  ScanLabels labels;
  for (const std::vector<TrackSample>& tracks : run.tracks) {
    labels.tracks = tracks;
    paths.add(labels);
  }
  return paths.paths();
}

}  // namespace

PictureMaker::PictureMaker(std::filesystem::path folder)
    : folder_(std::move(folder)),
      temporary_(folder_ / ".pictures"),
      scenes_{"scenes.png", "The scenes, movers in red", 3, 640, {}},
      errors_{"errors.png", "Errors of the default", 3, 640, {}},
      voting_{"voting.png", "Without and with DS-Voting", 2, 800, {}},
      comparison_{"comparison.png", "Auto-MOS, the paper, and the default", 3, 640, {}},
      terrain_{
          "rough_terrain.png", "Rough terrain: removed points red, traces of movers", 3, 640, {}} {
  std::filesystem::create_directories(temporary_);
}

PictureMaker::~PictureMaker() {
  std::error_code ignored;
  std::filesystem::remove_all(temporary_, ignored);
}

std::filesystem::path PictureMaker::nextFile() {
  return temporary_ / (std::to_string(files_++) + ".png");
}

void PictureMaker::addLog(const LabelledLog& log) {
  if (!canDraw_ || log.name == "real") return;
  const auto file = nextFile();
  try {
    renderPicture(contentOf(
                      log, [&](std::size_t s) -> const auto& { return log.labels[s]; }),
                  View::Corner, file, cellOptions());
  } catch (const RenderUnavailable& error) {
    std::cerr << "scoreboard: no pictures: " << error.what() << "\n";
    canDraw_ = false;
    return;
  }
  scenes_.entries[{"", files_}] = {file, log.name + ", " + log.sensor};
}

void PictureMaker::drawErrors(const FinishedCase& finished,
                              const std::vector<const char*>& variants, Sheet& sheet) {
  const int place = placeAmong(variants, finished.variant.name);
  if (place < 0) return;
  ErrorContent content;
  content.name = finished.log.name + ", " + finished.variant.name;
  content.keptStatic = finished.errors.kept, content.removedMoving = finished.errors.removed;
  content.keptMoving = finished.errors.residue, content.removedStatic = finished.errors.lost;
  const auto file = nextFile();
  renderErrors(content, View::Top, file, cellOptions());
  sheet.entries[{finished.log.name, place}] = {file, content.name};
}

void PictureMaker::drawTraces(const FinishedCase& finished) {
  MapContent content = contentOf(
      finished.log, [&](std::size_t s) -> const auto& { return finished.run.answers[s].final; });
  content.tracks = movingPaths(finished.run);
  const auto file = nextFile();
  renderPicture(content, View::Corner, file, cellOptions());
  terrain_.entries[{finished.log.name, 0}] = {file, finished.log.name};
}

void PictureMaker::addCase(const FinishedCase& finished) {
  if (!canDraw_) return;
  const std::string& scene = finished.log.name;
  drawErrors(finished, {kDefaultName}, errors_);
  if (placeAmong({"junction", "urban"}, scene) >= 0)
    drawErrors(finished, {kNoVotingName, kDefaultName}, voting_);
  if (placeAmong({"residential", "pedestrians"}, scene) >= 0)
    drawErrors(finished, {kAutoMosName, kPaperName, kDefaultName}, comparison_);
  if (placeAmong({"duckpond", "long-stairs", "steep-hills"}, scene) >= 0 &&
      finished.variant.kind == VariantKind::Default)
    drawTraces(finished);
}

std::vector<std::string> PictureMaker::finish() {
  std::vector<std::string> markdown;
  for (Sheet* sheet : {&scenes_, &errors_, &voting_, &comparison_, &terrain_}) {
    if (sheet->entries.empty()) continue;
    std::vector<SheetEntry> entries;
    for (const auto& [place, entry] : sheet->entries) entries.push_back(entry);
    writeContactSheet(entries, sheet->title, sheet->columns, sheet->cellWidth,
                      folder_ / sheet->file);
    markdown.push_back("![" + sheet->title + "](" + sheet->file + ")");
  }
  return markdown;
}

}  // namespace toss
