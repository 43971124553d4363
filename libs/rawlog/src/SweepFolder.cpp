// SPDX-License-Identifier: BSD-3-Clause
#include <toss/geometry/Error.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/AtomicFolder.h>
#include <toss/rawlog/MrptConversion.h>
#include <toss/rawlog/SweepFolder.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "RawlogStem.h"
#include "SweepFile.h"

namespace toss {
namespace {

constexpr const char* kSensorsFile = "sensors.json";

nlohmann::json toJson(const SensorModel& sensor) {
  return {{"model", sensor.name},
          {"elevations", sensor.elevations},
          {"columns", sensor.columns},
          {"min_range", sensor.minRange},
          {"max_range", sensor.maxRange}};
}

SensorModel fromJson(const nlohmann::json& json) {
  SensorModel sensor;
  json.at("model").get_to(sensor.name);
  json.at("elevations").get_to(sensor.elevations);
  json.at("columns").get_to(sensor.columns);
  json.at("min_range").get_to(sensor.minRange);
  json.at("max_range").get_to(sensor.maxRange);
  return sensor;
}

bool usable(const SensorModel& sensor) {
  const std::vector<float>& elevations = sensor.elevations;
  return !elevations.empty() && sensor.columns > 0 &&
         std::is_sorted(elevations.rbegin(), elevations.rend());
}

}  // namespace

std::filesystem::path sweepsFolderBeside(const std::filesystem::path& rawlog) {
  return besideRawlog(rawlog, "_sweeps");
}

std::string sweepFileName(const std::string& label, double time) {
  std::string name = label;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  constexpr std::int64_t kPerSecond = 10'000'000;
  const std::int64_t ticks = (toMrptTime(time) - toMrptTime(0.0)).count();
  const std::int64_t fraction = ((ticks % kPerSecond) + kPerSecond) % kPerSecond;
  char text[48];
  std::snprintf(text, sizeof text, "_%lld.%07lld.sweep",
                static_cast<long long>((ticks - fraction) / kPerSecond),
                static_cast<long long>(fraction));
  return name + text;
}

bool hasSweep(const PosedScan& scan) {
  return !scan.points.ring.empty() || !scan.points.time.empty() || scan.beams;
}

SweepFolderWriter::SweepFolderWriter(const std::filesystem::path& rawlog)
    : folder_(std::make_unique<AtomicFolder>(sweepsFolderBeside(rawlog))) {}

SweepFolderWriter::~SweepFolderWriter() = default;

void SweepFolderWriter::write(const PosedScan& scan, const std::string& label) {
  if (scan.beams) beams_[label] = scan.beams;
  writeSweep(folder_->temporaryPath() / sweepFileName(label, scan.time), scan);
}

void SweepFolderWriter::commit() {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [label, sensor] : beams_) json[label] = toJson(*sensor);
  writeTextAtomically(folder_->temporaryPath() / kSensorsFile,
                      json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  folder_->commit();
}

SweepFolder::SweepFolder(const std::filesystem::path& rawlog)
    : folder_(sweepsFolderBeside(rawlog)) {
  std::error_code ignored;
  exists_ = std::filesystem::is_directory(folder_, ignored);
  const std::filesystem::path file = folder_ / kSensorsFile;
  if (!exists_ || !std::filesystem::exists(file, ignored)) return;
  try {
    std::ifstream in(file);
    const nlohmann::json sensors = nlohmann::json::parse(in);
    for (const auto& [label, json] : sensors.items()) {
      beams_[label] = std::make_shared<const SensorModel>(fromJson(json));
      if (!usable(*beams_[label])) throw std::runtime_error("its beams are not in order");
    }
  } catch (const std::exception&) {
    throw UserError(file.string(), "is damaged: it does not describe the beams of the sensors",
                    "copy the folder again, or import the log again");
  }
}

bool SweepFolder::addTo(PosedScan& scan, const std::string& label) const {
  if (!exists_) return true;
  if (const auto sensor = beams_.find(label); sensor != beams_.end()) scan.beams = sensor->second;
  return addSweep(scan, label);
}

bool SweepFolder::addSweep(PosedScan& scan, const std::string& label) const {
  const std::filesystem::path file = folder_ / sweepFileName(label, scan.time);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return false;
  readSweep(file, scan);
  return true;
}

}  // namespace toss
