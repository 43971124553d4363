// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/PcdImport.h>

#include <iostream>
#include <map>
#include <memory>

#include "ImportCommands.h"
#include "Progress.h"

namespace toss {
namespace {

struct PcdRequest {
  std::filesystem::path input, output;
  std::string labels;
  PcdImportOptions options;
};

void import(PcdRequest& request, bool quiet) {
  Progress progress("importing", "%", quiet);
  request.options.labelsFromIntensity = !request.labels.empty();
  request.options.progress = [&](double share) {
    progress.update(static_cast<std::uint64_t>(100.0 * share), share);
  };
  const PcdImportResult result = importPcd(request.input, request.output, request.options);
  if (quiet) return;
  std::cout << request.output.string() << ": " << result.scans << " scans, " << result.points
            << " points";
  if (!request.labels.empty()) std::cout << ", " << result.moving << " of them labelled moving";
  std::cout << "\n";
  for (const std::string& warning : result.warnings) std::cout << "note: " << warning << "\n";
}

}  // namespace

void addImportPcd(CLI::App& import_, const Verbosity& verbosity) {
  auto request = std::make_shared<PcdRequest>();
  PcdImportOptions& options = request->options;
  using Frame = PcdImportOptions::Frame;
  CLI::App* pcd = import_.add_subcommand("pcd", "Folder of PCD files with VIEWPOINT poses");
  pcd->footer("Example: toss import pcd data/00 kitti00.rawlog --labels intensity");
  pcd->add_option("DIR", request->input, "Folder with the PCD files, or with pcd/")->required();
  pcd->add_option("OUT", request->output, "The rawlog")->required();
  pcd->add_option("--frame", options.frame, "Frame of the points: map (default) or sensor")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Frame>{{"map", Frame::Map}, {"sensor", Frame::Sensor}}));
  pcd->add_option("--labels", request->labels,
                  "intensity: the field holds 0 for static and 1 for moving")
      ->check(CLI::IsMember({"intensity"}));
  pcd->add_option("--poses", options.poses,
                  "Poses of the sensor instead of VIEWPOINT: TUM (by time) or KITTI (by number)");
  pcd->add_option("--period", options.period, "Time between two scans [s], 0.1 by default");
  pcd->add_option("--label", options.sensorLabel, "Label of the sensor in the rawlog");
  pcd->add_flag("--gz", options.gz, "Compress: a quarter smaller, some hundred times slower");
  pcd->callback([request, &verbosity] { import(*request, verbosity.quiet); });
}

}  // namespace toss
