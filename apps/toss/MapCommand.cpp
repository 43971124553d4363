// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "Command.h"
#include "MapRun.h"
#include "WholeNumber.h"

namespace toss {

void addMapCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<MapRequest>();
  CLI::App* command = program.add_subcommand(
      "map", "Turn a log into a clean static map, labels, tracks and pictures");
  command->footer("Example: toss map drive.rawlog --out result --set map.voxel_size=0.2");
  command->add_option("INPUT", request->input, "Rawlog, or folder in KITTI layout")->required();
  command->add_option("--out", request->output, "Folder for the results")->required();
  addConfigurationOptions(*command, request->configuration);
  command->add_flag("--odometry", request->odometry,
                    "Find the poses from the scans alone; they are left in poses.txt");
  command->add_option("--keep", request->configuration.keep,
                      "In doubt: static = keep, remove = take out (default: balanced)");
  command->add_option("--from", request->from, "First scan, counted from 0")->check(wholeNumber());
  command->add_option("--to", request->to, "Last scan, included")->check(wholeNumber());
  command->add_option("--threads", request->threads, "Threads; 0 = all cores")
      ->check(CLI::Range(0, 1024));
  command->add_flag("!--no-snapshots", request->snapshots, "Draw no pictures");
  command->add_flag("--live-labels", request->liveLabels,
                    "Also write the labels decided with no look-ahead");
  command->add_flag("--instances", request->instances,
                    "Also write classes and instances of segmentation, for toss eval's bounds");
  command->callback([request, &verbosity] { runMap(*request, verbosity); });
}

}  // namespace toss
