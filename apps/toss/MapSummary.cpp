// SPDX-License-Identifier: BSD-3-Clause
#include "MapSummary.h"

#include <toss/evaluation/RunScores.h>
#include <toss/rawlog/AtomicFile.h>

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

namespace toss {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::uintmax_t sizeOf(const fs::path& path) {
  if (!fs::is_directory(path)) return fs::file_size(path);
  std::uintmax_t sum = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file()) sum += entry.file_size();
  return sum;
}

/// "section": {"key": value as text}.
Json optionsJson(RunConfiguration& configuration) {
  Json json;
  for (Options* section : configuration.sections()) {
    Json& keys = json[section->section()];
    for (const auto& [key, value] : section->values()) keys[key] = value;
  }
  return json;
}

std::uint64_t scansOf(const LidarSetup& lidar, const MapOutputs& outputs) {
  const auto found = outputs.scansOf().find(lidar.label);
  return found == outputs.scansOf().end() ? 0 : found->second;
}

Json lidarsJson(const std::vector<LidarSetup>& lidars, const MapOutputs& outputs) {
  Json json = Json::array();
  for (const LidarSetup& lidar : lidars)
    json.push_back({{"label", lidar.label},
                    {"model", lidar.sensor.model.name},
                    {"preset", lidar.sensor.preset},
                    {"scans", scansOf(lidar, outputs)}});
  return json;
}

}  // namespace

void writeSummary(const MapRequest& request, std::vector<LidarSetup>& lidars,
                  const InputReport& input, const MapOutputs& outputs) {
  const RunCounts& counts = outputs.counts();
  Json json;
  json["program"] = "toss";
  json["version"] = TOSS_VERSION;
  json["input"] = {{"name", inputName(request)}, {"bytes", sizeOf(request.input)}};
  json["scans"] = {{"mapped", counts.scans},
                   {"skipped_for_pose", input.skippedForPose},
                   {"skipped_for_time", input.skippedForTime},
                   {"deskewed", input.deskewed},
                   {"empty", input.empty}};
  json["points"] = {{"read", counts.points},
                    {"invalid", counts.invalid},
                    {"moving", counts.moving},
                    {"static_map", counts.mapPoints}};
  json["tracks"] = {{"all", counts.tracks}, {"moving", counts.movingTracks}};
  if (lidars.size() > 1) json["lidars"] = lidarsJson(lidars, outputs);
  json["warnings"] = input.warnings;
  json["options"] = optionsJson(lidars.front().configuration);
  writeTextAtomically(request.output / "summary.json", json.dump(2) + "\n");
}

void printSummary(const MapRequest& request, const std::vector<LidarSetup>& lidars,
                  const InputReport& input, const MapOutputs& outputs) {
  const RunCounts& counts = outputs.counts();
  std::cout << counts.scans << " scans mapped";
  if (input.skippedForPose > 0) std::cout << ", " << input.skippedForPose << " skipped (no pose)";
  std::cout << ": " << counts.mapPoints << " map points, " << counts.moving
            << " moving returns removed, " << counts.movingTracks << " of " << counts.tracks
            << " tracks moved\n";
  if (lidars.size() > 1) {
    std::cout << "LiDARs:";
    for (const LidarSetup& lidar : lidars)
      std::cout << (&lidar == &lidars.front() ? " '" : ", '") << lidar.label << "' "
                << lidar.sensor.model.name << " " << scansOf(lidar, outputs) << " scans";
    std::cout << "\n";
  }
  double sum = 0.0;
  std::cout << std::fixed << std::setprecision(1) << "median ms per scan:";
  for (const auto& [stage, values] : outputs.times()) {
    const double median = quantile(values, 0.5);
    sum += median;
    std::cout << " " << stage << " " << median;
  }
  std::cout << ", together " << sum << "\n";
  for (const std::string& warning : input.warnings) std::cout << "note: " << warning << "\n";
  std::cout << "results in " << request.output.string() << "\n";
}

}  // namespace toss
