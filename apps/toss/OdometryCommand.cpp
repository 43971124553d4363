// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <map>
#include <memory>

#include "Command.h"
#include "OdometryRun.h"
#include "WholeNumber.h"

namespace toss {
namespace {

struct OdometryRequest {
  ScanChoice choice;
  std::filesystem::path output;
  PoseFileFormat format = PoseFileFormat::Tum;
  ConfigurationRequest configuration;
};

void run(const OdometryRequest& request, bool quiet) {
  const RunConfiguration configuration = configure(request.configuration, "");
  const Trajectory trajectory = findPoses(request.choice, configuration, quiet);
  writeTrajectory(trajectory, request.format, request.output, request.choice.input);
  if (quiet) return;
  std::cout << noteOn(trajectory);
  for (const std::string& warning : trajectory.warnings) std::cout << "note: " << warning << "\n";
}

}  // namespace

void addOdometryCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<OdometryRequest>();
  const std::map<std::string, PoseFileFormat> formats = {{"tum", PoseFileFormat::Tum},
                                                         {"kitti", PoseFileFormat::Kitti}};
  CLI::App* command =
      program.add_subcommand("odometry", "Find the poses of a log from its scans alone");
  command->footer("Example: toss odometry drive.rawlog --out poses.txt");
  command->add_option("INPUT", request->choice.input, "Rawlog, or folder in KITTI layout")
      ->required();
  command->add_option("--out", request->output, "The pose file")->required();
  command->add_option("--format", request->format, "tum or kitti; tum unless told otherwise")
      ->transform(CLI::CheckedTransformer(formats));
  addConfigurationOptions(*command, request->configuration, false);
  command->add_option("--from", request->choice.from, "First scan, counted from 0")
      ->check(wholeNumber());
  command->add_option("--to", request->choice.to, "Last scan, included")->check(wholeNumber());
  command->callback([request, &verbosity] { run(*request, verbosity.quiet); });
}

}  // namespace toss
