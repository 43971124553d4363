// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/EvaluationReport.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace toss {
namespace {

/// Keeps keys in the order in which they are written.
using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json ratesJson(const PreservationRejection& rates) {
  return {{"PR", number(rates.preservationRate())},
          {"RR", number(rates.rejectionRate())},
          {"F1", number(rates.f1())},
          {"static_voxels", rates.staticVoxels},
          {"static_kept", rates.staticKept},
          {"moving_voxels", rates.movingVoxels},
          {"moving_left", rates.movingLeft}};
}

Json countsJson(const VoxelCounts& counts, const char* right) {
  return {{"voxels", counts.voxels}, {right, counts.right}};
}

Json lossesJson(const LossTable& losses) {
  Json json;
  for (int c = 0; c < kLossCauses; ++c) {
    json["residue_by_cause"][lossCauseName(static_cast<LossCause>(c))] =
        losses.residueByCause.at(static_cast<std::size_t>(c));
  }
  for (int b = 0; b < kRangeBands; ++b) {
    const auto band = static_cast<std::size_t>(b);
    json["moving_by_range"][rangeBandName(b)] = countsJson(losses.movingByRange[band], "removed");
    json["static_by_range"][rangeBandName(b)] = countsJson(losses.staticByRange[band], "kept");
  }
  for (int s = 0; s < kReturnSteps; ++s) {
    json["moving_by_returns"][returnStepName(s)] =
        countsJson(losses.movingByReturns.at(static_cast<std::size_t>(s)), "removed");
  }
  return json;
}

Json removalJson(const RemovalAccuracy& removal) {
  return {{"SA", number(removal.staticAccuracy())},     {"DA", number(removal.dynamicAccuracy())},
          {"AA", number(removal.associatedAccuracy())}, {"HA", number(removal.harmonicAccuracy())},
          {"static_points", removal.staticPoints},      {"static_kept", removal.staticKept},
          {"moving_points", removal.movingPoints},      {"moving_removed", removal.movingRemoved}};
}

Json mapJson(const MapReport& map) {
  Json json = ratesJson(map.rates);
  if (map.removal) json["removal"] = removalJson(*map.removal);
  json["losses"] = lossesJson(map.losses);
  return json;
}

Json movingCountsJson(const MovingCounts& counts) {
  return {{"iou", number(counts.intersectionOverUnion())},
          {"precision", number(counts.precision())},
          {"recall", number(counts.recall())},
          {"true_positives", counts.truePositives},
          {"false_positives", counts.falsePositives},
          {"false_negatives", counts.falseNegatives}};
}

Json movingJson(const MovingScores& scores) {
  Json json = movingCountsJson(scores.all);
  for (int b = 0; b < kRangeBands; ++b) {
    const auto band = static_cast<std::size_t>(b);
    const ObjectCounts& objects = scores.objectsByRange[band];
    json["by_range"][rangeBandName(b)] = movingCountsJson(scores.byRange[band]);
    json["objects_by_range"][rangeBandName(b)] = {{"objects", objects.objects},
                                                  {"found", objects.found}};
  }
  json["by_class"] = Json::object();
  for (const auto& [trueClass, counts] : scores.byClass) {
    json["by_class"][std::to_string(trueClass)] = {{"points", counts.points},
                                                   {"called_moving", counts.calledMoving}};
  }
  return json;
}

Json trackingJson(const TrackingReport& tracking) {
  const ClearMot& clear = tracking.clear;
  return {{"MOTA", number(clear.accuracy())},
          {"MOTP", number(clear.precision())},
          {"recall", number(clear.recall())},
          {"AMOTA", number(tracking.averaged.amota)},
          {"sAMOTA", number(tracking.averaged.samota)},
          {"AMOTP", number(tracking.averaged.amotp)},
          {"objects", clear.objects},
          {"matches", clear.matches},
          {"misses", clear.misses},
          {"false_alarms", clear.falseAlarms},
          {"identity_switches", clear.identitySwitches},
          {"fragmentations", clear.fragmentations},
          {"trajectories", clear.trajectories},
          {"mostly_tracked", clear.mostlyTracked},
          {"mostly_lost", clear.mostlyLost}};
}

Json boundsJson(const std::vector<BoundReport>& bounds) {
  Json json = Json::array();
  for (const BoundReport& bound : bounds) {
    Json entry = {{"name", bound.name}};
    entry.update(ratesJson(bound.rates));
    entry["losses"] = lossesJson(bound.losses);
    json.push_back(std::move(entry));
  }
  return json;
}

Json stagesJson(const std::vector<StageTime>& stages) {
  Json json = Json::array();
  for (const StageTime& s : stages) {
    json.push_back({{"stage", s.stage},
                    {"scans", s.scans},
                    {"mean_ms", number(s.mean)},
                    {"median_ms", number(s.median)},
                    {"p95_ms", number(s.percentile95)},
                    {"max_ms", number(s.largest)}});
  }
  return json;
}

void addScores(const EvaluationReport& report, Json& json) {
  if (report.labels) json["labels"] = mapJson(*report.labels);
  if (report.liveLabels) json["live_labels"] = mapJson(*report.liveLabels);
  if (report.map) {
    json["map"] = mapJson(*report.map);
    json["map"]["points"] = report.mapPoints;
    json["map"]["points_without_return"] = report.mapPointsWithoutReturn;
  }
  if (report.moving) json["moving"] = movingJson(*report.moving);
  if (report.liveMoving) json["live_moving"] = movingJson(*report.liveMoving);
  if (report.tracking) json["tracking"] = trackingJson(*report.tracking);
  if (report.boxTracking) json["box_tracking"] = trackingJson(*report.boxTracking);
  json["bounds"] = boundsJson(report.bounds);
}

}  // namespace

std::string toJson(const EvaluationReport& report) {
  Json json = {{"truth", report.truth},
               {"run", report.run},
               {"scans", report.scans},
               {"points", report.points},
               {"scans_without_truth", report.scansWithoutTruth},
               {"scans_without_labels", report.scansWithoutLabels},
               {"unlabelled", report.unlabelledIgnored ? "ignored" : "static"},
               {"voxel_size", report.voxelSize}};
  addScores(report, json);
  json["times"] = {{"threads", report.threads},
                   {"processor", report.processor},
                   {"version", report.version},
                   {"wall_seconds", report.wallSeconds},
                   {"processor_seconds", report.processorSeconds},
                   {"scans_per_second", report.scansPerSecond},
                   {"peak_memory_bytes", report.peakMemoryBytes},
                   {"stages", stagesJson(report.stages)}};
  json["warnings"] = report.warnings;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace toss
