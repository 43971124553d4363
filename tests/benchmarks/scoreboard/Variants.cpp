// SPDX-License-Identifier: BSD-3-Clause
#include "Variants.h"

#include <toss/geometry/OptionSections.h>
#include <toss/voting/KeepChoice.h>

#include <algorithm>
#include <filesystem>

#include "OctoMapBaseline.h"

namespace toss {
namespace {

Variant configured(const std::string& name, const std::string& description, VariantKind kind,
                   const std::string& file, const std::vector<std::string>& settings) {
  return {name, description, kind, [file, settings](const LabelledLog& log) {
            return runPipeline(log, optionsOf(log.sensor, file, settings));
          }};
}

Variant without(const std::string& name, const std::string& description,
                const std::vector<std::string>& settings) {
  return configured(name, description, VariantKind::Ablation, "", settings);
}

Variant leaning(const std::string& keep, const std::string& description) {
  return {"keep " + keep, description, VariantKind::Ablation, [keep](const LabelledLog& log) {
            PipelineOptions options = optionsOf(log.sensor, "", {});
            leanTowards(keepFromName(keep), options.decision);
            return runPipeline(log, options);
          }};
}

std::vector<Variant> baselines() {
  std::vector<Variant> all = {
      {"naive", "every return stays", VariantKind::Baseline, keepEverything}};
  if (hasOctoMap())
    all.push_back({"OctoMap 0.2 m", "returns in voxels that OctoMap holds occupied at the end",
                   VariantKind::Baseline, runOctoMap});
  all.push_back(configured(kAutoMosName, "config/automos.ini: Auto-MOS on TRAVEL's instances",
                           VariantKind::Baseline, kAutoMosName, {}));
  all.push_back(configured(kPaperName, "config/paper.ini: the paper to the letter",
                           VariantKind::Baseline, kPaperName, {}));
  all.push_back(configured(kDefaultName, "TOSS as it is", VariantKind::Default, "", {}));
  return all;
}

std::vector<Variant> ablations() {
  return {
      leaning("static", "toss map --keep static: in doubt it stays"),
      leaning("remove", "toss map --keep remove: in doubt it goes"),
      without("no glimpses", "doubtful motion is no motion",
              {"decision.doubtful_glimpsed_share=1"}),
      without("no occluders", "what is near before a return hides it from a view",
              {"visibility.occluder_share=0"}),
      without("traces of 5", "traces need five returns",
              {"tracking.min_match_points=5", "tracking.min_birth_points=5"}),
      without("80 m", "returns beyond 80 m are in no instance", {"projection.max_range=80"}),
      without(kNoVotingName, "a box has the coarse class of its trace", {"voting.mode=off"}),
      without("literal voting", "the vote as it is printed", {"voting.mode=literal"}),
      without("no free space", "no other scan is asked", {"visibility.enabled=false"}),
      without("claims move", "what boxes claim moves, whatever else was measured in its place",
              {"decision.residue_place=0"}),
      without("no hindsight", "traces are not followed back from where they were first seen",
              {"decision.hindsight_time=0"}),
      without("no claims", "boxes take nothing beyond their instance", {"decision.claims=false"}),
      without("constant links", "link distances do not grow with range",
              {"objects.metric=constant"}),
      without("no splits", "long clusters are not cut", {"objects.split_extent=0"}),
      without("no attaching", "returns left over join no instance", {"objects.attach_distance=0"}),
      without("clusters of 10", "instances need 10 returns at any range",
              {"objects.min_points_near=10", "objects.min_points_far=10"}),
      without("TRAVEL's ground", "ground as TRAVEL finds it, feet and tyres in it",
              {"ground.max_fit_pts=0", "ground.min_layer_share=0", "ground.th_dist=0.125",
               "ground.min_buried_path=0", "ground.th_normal=0.94", "ground.min_spread=0",
               "ground.edge_policy=first_edge", "ground.island_policy=accept",
               "ground.terrain_rounds=0", "ground.subdivision=1", "ground.contact_slope=0"}),
      without("no reach", "sensors of few rows carry no terrain on along rings",
              {"ground.reach_rounds=0"}),
      without("crowns move", "what begins high above ground can move as well",
              {"boxes.max_clearance=10000"}),
      without("even rows", "rows by the paper's Eq. 1", {"projection.row_source=equation"}),
      without("no newborn gates", "traces seen once have no wider gates",
              {"tracking.newborn=false"}),
      without("paper's noise", "Kalman noise in metres per scan", {"tracking.noise=paper"}),
      without(kExhaustiveName, "every box is compared with every trace",
              {"tracking.association=exhaustive"}),
      without("Auto-MOS's rule", "displacement against the longest edge", {"motion.rule=automos"}),
  };
}

}  // namespace

PipelineOptions optionsOf(const std::string& sensor, const std::string& file,
                          const std::vector<std::string>& settings) {
  const std::filesystem::path folder = TOSS_CONFIG_FOLDER;
  PipelineOptions options;
  const std::filesystem::path preset = folder / "sensors" / (sensor + ".ini");
  if (std::filesystem::exists(preset)) loadSections(preset, options.sections());
  if (!file.empty()) loadSections(folder / file, options.sections());
  for (const std::string& setting : settings) setOption(setting, options.sections());
  return options;
}

std::vector<Variant> allVariants(bool quick) {
  std::vector<Variant> all = baselines();
  for (Variant& part : ablations()) {
    const bool timed = part.name == kExhaustiveName;
    if (quick && timed) part.scenes = {"duckpond", "long-stairs", "steep-hills"};
    if (!quick || timed || part.name == kNoVotingName) all.push_back(std::move(part));
  }
  const auto slow = [](const Variant& v) { return v.name.rfind("OctoMap", 0) == 0; };
  if (quick) all.erase(std::remove_if(all.begin(), all.end(), slow), all.end());
  return all;
}

}  // namespace toss
