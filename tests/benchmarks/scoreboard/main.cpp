// SPDX-License-Identifier: BSD-3-Clause
// Scores TOSS and its parts on all scenes, and writes the table, plots and pictures.
#include <toss/geometry/Error.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "AssociationPlot.h"
#include "Pictures.h"
#include "Plots.h"
#include "ResultsDocument.h"
#include "Scoreboard.h"

namespace {

using namespace toss;

void readArguments(CLI::App& program, ScoreboardRequest& request) {
  program.add_flag("--quick", request.quick, "40 scans per scene, one seed, few variants");
  program.add_option("--frames", request.frames,
                     "Most scans per scene (default: 100); 0 = the scene's own number");
  program.add_option("--seeds", request.seeds, "Seeds per scene, 1 with --quick")
      ->check(CLI::Range(1, 100));
  program.add_option("--jobs", request.jobs, "Cases at a time")->check(CLI::Range(1, 256));
  program.add_option("--scene", request.scenes, "Only these scenes; 'none' for no simulated one");
  program.add_option("--variant", request.variants, "Only these variants, by name");
  program.add_option("--real", request.realSequence, "Labelled real sequence, KITTI layout");
  program.add_option("--commit", request.commit, "Name of the commit, for the report");
  program.add_option("OUTPUT", request.output, "Folder for results.md and pictures")->required();
}

void checkNames(const std::vector<std::string>& wanted, const std::vector<Variant>& all) {
  std::string names;
  for (const Variant& variant : all) names += (names.empty() ? "" : ", ") + variant.name;
  for (const std::string& name : wanted) {
    const auto hasName = [&](const Variant& variant) { return variant.name == name; };
    if (std::none_of(all.begin(), all.end(), hasName))
      throw UserError("--variant " + name, "there is none of that name", "take some of: " + names);
  }
}

std::vector<Variant> chosenVariants(const ScoreboardRequest& request) {
  std::vector<Variant> all = allVariants(request.quick);
  if (request.variants.empty()) return all;
  checkNames(request.variants, all);
  const auto isUnwanted = [&](const Variant& variant) {
    const auto& wanted = request.variants;
    return std::find(wanted.begin(), wanted.end(), variant.name) == wanted.end();
  };
  all.erase(std::remove_if(all.begin(), all.end(), isUnwanted), all.end());
  return all;
}

void run(ScoreboardRequest& request) {
  constexpr int kQuickFrames = 40;
  if (request.quick) request.frames = kQuickFrames, request.seeds = 1;
  std::filesystem::create_directories(request.output);
  const std::vector<Variant> variants = chosenVariants(request);
  const AssociationStudy association = studyAssociation();
  PictureMaker pictures(request.output);
  const std::vector<CaseResult> results =
      runScoreboard(request, variants,
                    {[&](const LabelledLog& log) { pictures.addLog(log); },
                     [&](const FinishedCase& finished) { pictures.addCase(finished); }});
  if (results.empty())
    throw UserError("scoreboard", "there is no log to run on", "name a scene, or give --real");
  const std::vector<std::string> drawn = pictures.finish();
  drawPlots(results, variants, request.output);
  drawAssociation(association, request.output / "association.png");
  writeResults(request, results, variants, association, drawn);
  std::cout << (request.output / "results.md").string() << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  ScoreboardRequest request;
  CLI::App program("Scores TOSS on simulated scenes and real data");
  readArguments(program, request);
  CLI11_PARSE(program, argc, argv);
  try {
    run(request);
  } catch (const std::exception& error) {
    std::cerr << "scoreboard: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
