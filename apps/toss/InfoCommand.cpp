// SPDX-License-Identifier: BSD-3-Clause
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/InputSummary.h>

#include <iostream>
#include <memory>

#include "Command.h"
#include "RunConfiguration.h"

namespace toss {
namespace {

struct InfoRequest {
  std::filesystem::path input, json;
  ConfigurationRequest configuration;
};

void inform(const InfoRequest& request) {
  const InputSummary summary =
      summarizeInput(request.input, configure(request.configuration, "").input);
  if (!request.json.empty()) writeTextAtomically(request.json, toJson(summary));
  std::cout << toText(summary);
}

}  // namespace

void addInfoCommand(CLI::App& program, const Verbosity&) {
  auto request = std::make_shared<InfoRequest>();
  CLI::App* command = program.add_subcommand("info", "Tell what is in a rawlog or a dataset");
  command->footer("Example: toss info drive.rawlog");
  command->add_option("INPUT", request->input, "Rawlog, or folder in KITTI layout")->required();
  command->add_option("--json", request->json, "Also write the answer to this file");
  addConfigurationOptions(*command, request->configuration);
  command->callback([request] { inform(*request); });
}

}  // namespace toss
