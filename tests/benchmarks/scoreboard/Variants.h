// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/MethodRun.h>

#include <functional>
#include <string>
#include <vector>

namespace toss {

/// What a row of the scoreboard stands for.
enum class VariantKind {
  Baseline,  ///< another method, or another configuration as a whole
  Default,   ///< TOSS as it is
  Ablation   ///< TOSS with one part off or as the paper has it
};

/// A way to clean a map.
struct Variant {
  /// Name for tables, and a sentence on what it is.
  std::string name, description;
  VariantKind kind;
  std::function<MethodRun(const LabelledLog&)> run;
  /// The only scenes to run on; empty = all.
  std::vector<std::string> scenes = {};
};

/// Names of the variants that pictures and sections are made of.
constexpr const char* kDefaultName = "default";
constexpr const char* kPaperName = "paper.ini";
constexpr const char* kAutoMosName = "automos.ini";
constexpr const char* kExhaustiveName = "exhaustive";
constexpr const char* kNoVotingName = "no DS-Voting";

/// Options of TOSS on a log of that sensor: defaults, the sensor's preset, `file` ("" = none) of
/// the folder config, then `settings` as "section.key=value". Throws UserError.
PipelineOptions optionsOf(const std::string& sensor, const std::string& file,
                          const std::vector<std::string>& settings);

/// All variants, in the order of the tables; only the most telling ones if `quick`.
std::vector<Variant> allVariants(bool quick);

}  // namespace toss
