// SPDX-License-Identifier: BSD-3-Clause
#include "ResultsDocument.h"

#include <toss/rawlog/AtomicFile.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "AssociationSection.h"
#include "ResultSummary.h"

namespace toss {
namespace {

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

void writeHead(std::ostream& out, const ScoreboardRequest& request) {
  out << "# Results\n\nWritten by `bash tests/benchmarks/scoreboard.sh"
      << (request.quick ? " --quick" : "") << "`"
      << (request.commit.empty() ? "" : " at commit " + request.commit) << ". " << processorName()
      << ", " << std::thread::hardware_concurrency() << " cores, " << request.jobs
      << " cases at a time, one thread each";
  if (request.frames > 0) out << "; at most " << request.frames << " scans per scene";
  out << "; means over " << request.seeds
      << (request.seeds == 1 ? " seed.\n\n" : " seeds (ablations and OctoMap: seed 1).\n\n");
  out << "PR, RR [%] and F1 as ERASOR counts them, in voxels of 0.2 m. Scenes of `toss simulate`; "
         "`real` is KITTI tracking sequence 0000, returns without annotation left out. Worst scene "
         "first.\n\n";
}

void writeOverview(std::ostream& out, const std::vector<CaseResult>& results,
                   const std::vector<Variant>& variants) {
  out << "## Maps\n\nPR / RR / F1.\n\n| scene |";
  std::string rule = "\n|---|";
  std::vector<const Variant*> shown;
  for (const Variant& v : variants)
    if (v.kind != VariantKind::Ablation) shown.push_back(&v);
  for (const Variant* v : shown) out << " " << v->name << " |", rule += "---|";
  out << rule << "\n";
  for (const std::string& scene : scenesWorstFirst(results)) {
    out << "| " << scene << " |";
    for (const Variant* v : shown) {
      const SceneScore s = sceneScore(results, scene, v->name);
      const char* mark = v->kind == VariantKind::Default ? "**" : "";
      if (s.seeds == 0) out << " - |";
      if (s.seeds > 0)
        out << " " << numberText(s.preservation, 2) << " / " << numberText(s.rejection, 2) << " / "
            << mark << numberText(s.f1, 3) << mark << " |";
    }
    out << "\n";
  }
  out << "\n![F1 of every scene](results_scenes.png)\n\n";
  for (const Variant* v : shown) out << "- " << v->name << ": " << v->description << "\n";
}

void writeAblation(std::ostream& out, const std::vector<CaseResult>& results,
                   const std::vector<Variant>& variants) {
  out << "\n## What each part is worth\n\nMean of a variant minus the default over the scenes it "
         "ran on. "
         "IoU: "
         "of moving points, final labels.\n\n| variant | PR | RR | F1 | IoU | ms per scan | F1 "
         "changes most in | what it is |\n|---|---|---|---|---|---|---|---|\n";
  for (const Variant& v : variants) {
    if (v.kind != VariantKind::Ablation) continue;
    const Difference d = differenceToDefault(results, v.name);
    out << "| " << v.name << " | " << numberText(d.preservation, 2, true) << " | "
        << numberText(d.rejection, 2, true) << " | " << numberText(d.f1, 4, true) << " | "
        << numberText(d.iou, 2, true) << " | " << numberText(d.milliseconds, 1, true) << " | "
        << d.mostChanged << " (" << numberText(d.mostChange, 3, true) << ") | " << v.description
        << " |\n";
  }
  out << "\n![Change of F1 by variant](results_ablation.png)\n";
}

/// A table with a row per scene for the default. `cells`: the row's values, after the scene.
void writeDefaultTable(std::ostream& out, const std::vector<CaseResult>& results,
                       const std::vector<std::string>& columns,
                       const std::function<std::vector<std::string>(const RunScores&)>& cells) {
  std::string rule = "\n|---|";
  out << "\n| scene |";
  for (const std::string& column : columns) out << " " << column << " |", rule += "---|";
  out << rule << "\n";
  for (const std::string& scene : scenesWorstFirst(results)) {
    const CaseResult* result = firstResult(results, scene, kDefaultName);
    if (result == nullptr) continue;
    out << "| " << scene << " |";
    for (const std::string& cell : cells(result->scores)) out << " " << cell << " |";
    out << "\n";
  }
}

template <typename Counts>
void addShares(const Counts& counts, std::vector<std::string>& cells) {
  for (const VoxelCounts& c : counts)
    cells.push_back(
        numberText(100.0 * static_cast<double>(c.right) / static_cast<double>(c.voxels), 2));
}

void writeResidue(std::ostream& out, const std::vector<CaseResult>& results) {
  out << "\n## Where what is left comes from\n\nMoving voxels that the default leaves in the map, "
         "in percent of all moving voxels, by cause (seed 1).\n";
  std::vector<std::string> columns = {"moving voxels"};
  for (int c = 0; c < kLossCauses; ++c)
    columns.emplace_back(lossCauseName(static_cast<LossCause>(c)));
  writeDefaultTable(out, results, columns, [](const RunScores& scores) {
    const auto all = static_cast<double>(scores.map.movingVoxels);
    std::vector<std::string> cells = {std::to_string(scores.map.movingVoxels)};
    for (const std::uint64_t voxels : scores.losses.residueByCause)
      cells.push_back(numberText(100.0 * static_cast<double>(voxels) / all, 2));
    return cells;
  });
}

void writeBands(std::ostream& out, const std::vector<CaseResult>& results) {
  out << "\n## By distance and by returns\n\nRR of the default by distance from the sensor and by "
         "the object's returns in the scan, and PR by distance [%] (seed 1).\n";
  std::vector<std::string> columns;
  for (int b = 0; b < kRangeBands; ++b) columns.push_back(std::string("RR ") + rangeBandName(b));
  for (int s = 0; s < kReturnSteps; ++s)
    columns.push_back(std::string("RR ") + returnStepName(s) + " returns");
  for (int b = 0; b < kRangeBands; ++b) columns.push_back(std::string("PR ") + rangeBandName(b));
  writeDefaultTable(out, results, columns, [](const RunScores& scores) {
    std::vector<std::string> cells;
    addShares(scores.losses.movingByRange, cells);
    addShares(scores.losses.movingByReturns, cells);
    addShares(scores.losses.staticByRange, cells);
    return cells;
  });
}

void writeStages(std::ostream& out, const std::vector<CaseResult>& results) {
  out << "\n## Where the time goes\n\nMedian per scan of the default by stage [ms] (seed 1); rest: "
         "what is left to do "
         "when the log ends, most of it the map, shared equally among the scans.\n";
  std::vector<std::string> columns;
  const CaseResult* any = firstResult(results, results.front().scene, kDefaultName);
  for (const auto& [stage, time] : any->scores.stageMedians) columns.push_back(stage);
  writeDefaultTable(out, results, columns, [](const RunScores& scores) {
    std::vector<std::string> cells;
    for (const auto& [stage, time] : scores.stageMedians) cells.push_back(numberText(time, 2));
    return cells;
  });
}

void writeCases(std::ostream& out, const std::vector<CaseResult>& results,
                const std::vector<Variant>& variants) {
  out << "\n## All cases\n\nIoU [%] of moving points by final labels, and live by labels with no "
         "look-ahead. Bounds: RR [%] that the right class for every instance, or trace, would "
         "reach.\n\n| scene | scans | variant | PR | RR | F1 | IoU | live IoU | instance bound | "
         "trace bound | ms per scan, median | 95 % |\n|---|---|---|---|---|---|---|---|---|---|---|"
         "---|\n";
  for (const std::string& scene : scenesWorstFirst(results))
    for (const Variant& v : variants) {
      const SceneScore s = sceneScore(results, scene, v.name);
      if (s.seeds == 0) continue;
      out << "| " << scene << " | " << s.scans << " | " << v.name << " | "
          << numberText(s.preservation, 2) << " | " << numberText(s.rejection, 2) << " | "
          << numberText(s.f1, 3) << " | " << numberText(s.iou, 2) << " | "
          << numberText(s.liveIou, 2) << " | " << numberText(s.instanceBound, 2) << " | "
          << numberText(s.traceBound, 2) << " | " << numberText(s.median, 1) << " | "
          << numberText(s.percentile95, 1) << " |\n";
    }
}

}  // namespace

void writeResults(const ScoreboardRequest& request, const std::vector<CaseResult>& results,
                  const std::vector<Variant>& variants, const AssociationStudy& association,
                  const std::vector<std::string>& pictures) {
  std::ostringstream out;
  writeHead(out, request);
  writeOverview(out, results, variants);
  writeAblation(out, results, variants);
  writeResidue(out, results);
  writeBands(out, results);
  writeStages(out, results);
  writeAssociation(out, association, results);
  if (!pictures.empty())
    out << "\n## Pictures\n\nIn pictures of errors, moving points that were removed are green, "
           "moving "
           "points left behind red, static points lost blue.\n";
  for (const std::string& picture : pictures) out << "\n" << picture << "\n";
  writeCases(out, results, variants);
  writeTextAtomically(request.output / "results.md", out.str());
}

}  // namespace toss
