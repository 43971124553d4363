// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/LidarSelection.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "Command.h"
#include "MotionSurvey.h"
#include "Progress.h"
#include "RunConfiguration.h"
#include "ScanRange.h"
#include "ScanSurvey.h"
#include "WholeNumber.h"

namespace toss {
namespace {

constexpr const char* kUnreadable = "unreadable";

struct CheckRequest {
  std::filesystem::path input, json;
  ConfigurationRequest configuration;
  std::uint64_t from = 0, to = std::numeric_limits<std::uint64_t>::max();
};

const char* nameOf(Severity severity) {
  constexpr const char* kNames[] = {"fault", "doubt", "note"};
  return kNames[static_cast<int>(severity)];
}

/// Everything that is found; scans and sensor for the head line.
struct CheckResult {
  Findings findings;
  std::uint64_t scans = 0;
  std::string sensor;

  std::uint64_t faults() const {
    return static_cast<std::uint64_t>(
        std::count_if(findings.begin(), findings.end(),
                      [](const Finding& f) { return f.severity == Severity::Fault; }));
  }
};

/// Of several LiDARs the first one is looked at.
void reportLidars(const LidarSelection& selection, Findings& findings) {
  for (const std::string& note : selection.notes)
    findings.push_back({Severity::Doubt, "lidars", note, ""});
  if (selection.labels.size() < 2) return;
  std::string labels;
  for (const std::string& label : selection.labels)
    labels += (labels.empty() ? "'" : ", '") + label + "'";
  findings.push_back(
      {Severity::Note, "lidars",
       "several LiDARs will be mapped (" + labels + "); what is found is of the first",
       "check the others with --set input.sensor_label=NAME"});
}

/// Looks at the scans, with their poses or without. An error that ends the reading is a finding.
CheckResult look(const CheckRequest& request, const RunConfiguration& configuration, bool quiet) {
  CheckResult result;
  ScanSurvey scans;
  MotionSurvey motion(configuration.odometry, !configuration.input.withoutPoses);
  Progress progress("checking", "scans", quiet);
  InputReport report;
  try {
    const LidarSelection lidars = selectLidars(request.input, configuration.input);
    reportLidars(lidars, result.findings);
    InputOptions input = configuration.input;
    input.sensorLabels = lidars.labels;
    ScanRange source(request.input, input, request.from, request.to);
    PosedScan scan;
    const auto keepReport = [&] { report = source.report(); };
    try {
      while (source.next(scan)) {
        if (!input.sensorLabels.empty() && scan.sensorLabel != input.sensorLabels.front()) continue;
        scans.look(scan);
        motion.look(scan);
        progress.update(scans.scans(), source.progress());
      }
    } catch (const UserError&) {
      keepReport();
      throw;
    }
    keepReport();
  } catch (const UserError& error) {
    result.findings.push_back({Severity::Fault, kUnreadable, error.what(), ""});
  }
  scans.report(report, result.findings);
  motion.report(result.findings);
  result.scans = scans.scans();
  result.sensor = scans.sensor();
  return result;
}

/// Where no scan has a pose, the scans are looked at without.
CheckResult check(const CheckRequest& request, RunConfiguration configuration, bool quiet) {
  const CheckResult posed = look(request, configuration, quiet);
  if (posed.scans > 0) return posed;
  configuration.input.withoutPoses = true;
  CheckResult bare = look(request, configuration, quiet);
  if (bare.scans == 0) return posed;
  std::copy_if(posed.findings.begin(), posed.findings.end(), std::back_inserter(bare.findings),
               [](const Finding& f) { return f.key == kUnreadable; });
  return bare;
}

std::string toJson(const CheckRequest& request, const CheckResult& result) {
  nlohmann::ordered_json json;
  json["input"] = request.input.string();
  json["scans"] = result.scans;
  json["sensor"] = result.sensor;
  json["fit"] = result.faults() == 0;
  json["findings"] = nlohmann::json::array();
  for (const Finding& f : result.findings)
    json["findings"].push_back(
        {{"severity", nameOf(f.severity)}, {"key", f.key}, {"text", f.text}, {"remedy", f.remedy}});
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void run(const CheckRequest& request, const Verbosity& verbosity) {
  CheckResult result = check(request, configure(request.configuration, ""), verbosity.quiet);
  std::stable_sort(result.findings.begin(), result.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity < b.severity; });
  if (!request.json.empty()) writeTextAtomically(request.json, toJson(request, result));
  if (!verbosity.quiet) {
    std::cout << request.input.string() << ": " << result.scans << " scans, sensor "
              << (result.sensor.empty() ? "unknown" : result.sensor) << "\n";
    for (const Finding& f : result.findings)
      std::cout << nameOf(f.severity) << " " << f.key << ": " << f.text
                << (f.remedy.empty() ? "" : "; " + f.remedy) << "\n";
  }
  if (const std::uint64_t faults = result.faults(); faults > 0)
    throw UserError(request.input.string(),
                    "is unfit to be mapped, faults: " + std::to_string(faults) + ", first " +
                        result.findings.front().key,
                    "mend what toss check lists");
  if (!verbosity.quiet) std::cout << "fit to be mapped\n";
}

}  // namespace

void addCheckCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<CheckRequest>();
  CLI::App* command = program.add_subcommand(
      "check",
      "Tell whether a log is fit to be mapped, and what to do about it; exit code 1 if not");
  command->footer("Example: toss check drive.rawlog");
  command->add_option("INPUT", request->input, "Rawlog, or folder in KITTI layout")->required();
  addConfigurationOptions(*command, request->configuration);
  command->add_option("--json", request->json, "Also write the findings to this file");
  command->add_option("--from", request->from, "First scan, counted from 0")->check(wholeNumber());
  command->add_option("--to", request->to, "Last scan, included")->check(wholeNumber());
  command->callback([request, &verbosity] { run(*request, verbosity); });
}

}  // namespace toss
