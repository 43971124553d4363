// SPDX-License-Identifier: BSD-3-Clause
#include "RunNotes.h"

#include <toss/geometry/Error.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace toss {
namespace {

std::vector<std::string> cellsOf(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

bool isStage(const std::string& column) {
  return column != "scan" && column != "index" && column != "time";
}

/// "ground_ms" is the stage "ground".
std::string stageName(const std::string& column) {
  const std::size_t unit = column.rfind("_ms");
  return unit != std::string::npos && unit + 3 == column.size() ? column.substr(0, unit) : column;
}

double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = std::ceil(share * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(rank, 0.0))];
}

StageTime summarize(const std::string& stage, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  StageTime result{stage, times.size()};
  if (times.empty()) return result;
  const double sum = std::accumulate(times.begin(), times.end(), 0.0);
  result.mean = sum / static_cast<double>(times.size());
  result.median = quantile(times, 0.5), result.percentile95 = quantile(times, 0.95);
  result.largest = times.back();
  return result;
}

double numberIn(const std::string& cell, const std::filesystem::path& file, std::size_t line) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (end == cell.c_str() || *end != '\0' || !std::isfinite(value)) {
    throw UserError(file.string() + ": line " + std::to_string(line),
                    "'" + cell + "' is no number of milliseconds", "run toss map again");
  }
  return value;
}

std::string textOf(const nlohmann::json& summary, const char* key) {
  const auto found = summary.find(key);
  if (found == summary.end()) return {};
  return found->is_string() ? found->get<std::string>() : found->dump();
}

nlohmann::json readObject(const std::filesystem::path& file) {
  std::ifstream in(file);
  nlohmann::json object = nlohmann::json::parse(in, nullptr, false);
  if (!object.is_object())
    throw UserError(file.string(), "is no JSON object", "run toss map again or remove the file");
  return object;
}

/// The number of a key; 0 where there is none.
double numberOf(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

}  // namespace

std::vector<StageTime> readStageTimes(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = cellsOf(line);
  std::vector<std::vector<double>> columns(header.size());
  for (std::size_t number = 2; std::getline(in, line); ++number) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != header.size()) {
      throw UserError(file.string() + ": line " + std::to_string(number),
                      "has another number of cells than the first line", "run toss map again");
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (isStage(header[c])) columns[c].push_back(numberIn(cells[c], file, number));
    }
  }
  std::vector<StageTime> stages;
  for (std::size_t c = 0; c < header.size(); ++c) {
    if (isStage(header[c]))
      stages.push_back(summarize(stageName(header[c]), std::move(columns[c])));
  }
  return stages;
}

void readSummary(const std::filesystem::path& file, EvaluationReport& report) {
  const nlohmann::json summary = readObject(file);
  report.threads = textOf(summary, "threads");
  report.processor = textOf(summary, "processor");
  report.version = textOf(summary, "version");
}

void readResources(const std::filesystem::path& file, EvaluationReport& report) {
  const nlohmann::json resources = readObject(file);
  if (resources.contains("threads")) report.threads = textOf(resources, "threads");
  if (resources.contains("processor")) report.processor = textOf(resources, "processor");
  report.wallSeconds = numberOf(resources, "wall_seconds");
  report.processorSeconds = numberOf(resources, "processor_seconds");
  report.scansPerSecond = numberOf(resources, "scans_per_second");
  report.peakMemoryBytes = numberOf(resources, "peak_memory_bytes");
}

}  // namespace toss
