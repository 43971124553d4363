// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/Evaluation.h>
#include <toss/evaluation/EvaluationOptions.h>
#include <toss/evaluation/EvaluationReport.h>
#include <toss/evaluation/PreservationRejection.h>
#include <toss/geometry/OptionSections.h>
#include <toss/rawlog/AtomicFile.h>
#include <toss/rawlog/InputOptions.h>
#include <toss/render/Snapshots.h>

#include <iostream>
#include <memory>

#include "Command.h"
#include "Progress.h"

namespace toss {
namespace {

struct EvalRequest {
  std::filesystem::path truth, run, json, picture;
  std::vector<std::string> settings;
  bool labelledOnly = false;
};

void drawErrors(const EvalRequest& request, const MapErrors& errors) {
  ErrorContent content;
  content.name = request.run.filename().string();
  content.keptStatic = errors.kept;
  content.removedMoving = errors.removed;
  content.keptMoving = errors.residue;
  content.removedStatic = errors.lost;
  renderErrors(content, View::Top, request.picture, RenderOptions());
}

void evaluate(const EvalRequest& request, bool quiet) {
  EvaluationOptions options;
  InputOptions input;
  if (request.labelledOnly) options.set("unlabelled", "ignore");
  for (const std::string& setting : request.settings) setOption(setting, {&options, &input});
  Progress progress("scoring", "%", quiet);
  MapErrors errors;
  const EvaluationReport report = evaluateRun(
      request.truth, request.run, options, input,
      [&](double share) { progress.update(static_cast<std::uint64_t>(100.0 * share), share); },
      request.picture.empty() ? nullptr : &errors);
  if (!request.json.empty()) writeTextAtomically(request.json, toJson(report));
  if (!request.picture.empty()) drawErrors(request, errors);
  if (!quiet) std::cout << toText(report);
}

}  // namespace

void addEvalCommand(CLI::App& program, const Verbosity& verbosity) {
  auto request = std::make_shared<EvalRequest>();
  CLI::App* command =
      program.add_subcommand("eval", "Score a run or a map against ground-truth labels");
  command->footer("Example: toss eval drive.rawlog result --json scores.json");
  command->add_option("TRUTH", request->truth, "Rawlog or KITTI folder with labels")->required();
  command
      ->add_option("RUN_DIR", request->run,
                   "Folder of toss map, folder of .label files, or a map (PLY, PCD)")
      ->required();
  command->add_option("--json", request->json, "Also write the scores to this file");
  command->add_option("--picture", request->picture,
                      "Also draw what was removed, left behind and lost (PNG)");
  command->add_option("--set", request->settings, "evaluation.key=value or input.key=value")
      ->allow_extra_args(false);
  command->add_flag("--labelled-only", request->labelledOnly,
                    "Leave out returns whose true label is 0 (not annotated)");
  command->callback([request, &verbosity] { evaluate(*request, verbosity.quiet); });
}

}  // namespace toss
