// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>

#include <iostream>
#include <memory>

#include "Command.h"
#include "SemanticKittiBenchmark.h"

namespace toss {
namespace {

void benchmark(const SemanticKittiRequest& request, bool quiet) {
  const std::string table = runSemanticKittiBenchmark(request, quiet);
  if (!request.output.empty()) writeTextAtomically(request.output, table);
  if (!quiet || request.output.empty()) std::cout << table;
}

}  // namespace

void addBenchmarkCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<SemanticKittiRequest>();
  CLI::App* command = program.add_subcommand("benchmark", "Score TOSS on a public benchmark");
  command->footer("Example: toss benchmark semantickitti /data/semantickitti/dataset");
  command->require_subcommand(1);
  CLI::App* kitti = command->add_subcommand(
      "semantickitti", "The five ranges of SemanticKITTI that ERASOR and TOSS are published on");
  kitti->footer("Example: toss benchmark semantickitti /data/semantickitti/dataset --out table.md");
  kitti->add_option("DIR", request->folder, "Folder that holds sequences/00 and so on")->required();
  kitti->add_option("--out", request->output, "Also write the table to this file (Markdown)");
  kitti->add_option("--config", request->configuration.file, "Configuration, an .ini file");
  kitti->add_option("--set", request->configuration.settings, "section.key=value, repeatable")
      ->allow_extra_args(false);
  kitti->callback([request, &verbosity] { benchmark(*request, verbosity.quiet); });
}

}  // namespace toss
