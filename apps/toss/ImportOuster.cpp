// SPDX-License-Identifier: BSD-3-Clause
#include <toss/import/OusterImport.h>

#include <iostream>
#include <memory>

#include "ImportCommands.h"
#include "Progress.h"

namespace toss {
namespace {

struct OusterRequest {
  std::filesystem::path capture, metadata, output;
  OusterImportOptions options;
};

void import(OusterRequest& request, bool quiet) {
  Progress progress("importing", "%", quiet);
  request.options.progress = [&](double share) {
    progress.update(static_cast<std::uint64_t>(100.0 * share), share);
  };
  const OusterImportResult result =
      importOuster(request.capture, request.metadata, request.output, request.options);
  if (quiet) return;
  std::cout << request.output.string() << ": " << result.scans << " scans, " << result.posed
            << " with poses, " << result.points << " points\n";
  for (const std::string& warning : result.warnings) std::cout << "note: " << warning << "\n";
}

}  // namespace

void addImportOuster(CLI::App& import_, const Verbosity& verbosity) {
  auto request = std::make_shared<OusterRequest>();
  OusterImportOptions& options = request->options;
  CLI::App* ouster = import_.add_subcommand("ouster", "Capture (pcap) of an Ouster sensor");
  ouster->footer(
      "Example: toss import ouster drive.pcap drive.json drive.rawlog --poses drive.tum");
  ouster->add_option("FILE", request->capture, "The capture: pcap or pcapng")->required();
  ouster->add_option("META", request->metadata, "The sensor's metadata that were saved with it")
      ->required();
  ouster->add_option("OUT", request->output, "The rawlog")->required();
  ouster->add_option("--poses", options.poses,
                     "Poses of the sensor: TUM (by time) or KITTI (by number of the frame)");
  ouster->add_option("--label", options.sensorLabel,
                     "Label of the sensor in the rawlog; by default its model");
  ouster->add_flag("--gz", options.gz, "Compress: a quarter smaller, some hundred times slower");
  ouster->callback([request, &verbosity] { import(*request, verbosity.quiet); });
}

}  // namespace toss
