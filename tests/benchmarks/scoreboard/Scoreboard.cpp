// SPDX-License-Identifier: BSD-3-Clause
#include "Scoreboard.h"

#include <toss/simulation/SceneCatalogue.h>
#include <toss/simulation/Simulator.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <thread>

namespace toss {
namespace {

LabelledLog simulate(const std::string& scene, std::uint64_t seed, int frames) {
  SimulationOptions options;
  options.scene = scene, options.seed = seed;
  options.frames = frames > 0 ? std::min(frames, sceneByName(scene).frames) : 0;
  Simulator simulator(options);
  LabelledLog log;
  log.name = scene, log.sensor = simulator.sensorName();
  for (SimulatedScan scan; simulator.next(scan);) {
    log.scans.push_back(scan.scan);
    log.labels.push_back(scan.labels);
  }
  return log;
}

bool runsOn(const Variant& variant, const std::string& scene, std::uint64_t seed) {
  const auto& only = variant.scenes;
  if (!only.empty() && std::find(only.begin(), only.end(), scene) == only.end()) return false;
  const bool slow = variant.name.rfind("OctoMap", 0) == 0;
  return seed == 1 || (variant.kind != VariantKind::Ablation && !slow);
}

/// The variants on one log, as many at a time as asked for.
class LogRunner {
 public:
  LogRunner(const LabelledLog& log, std::uint64_t seed, const ScoreboardObserver& observer)
      : log_(log), seed_(seed), observer_(observer) {}

  std::vector<CaseResult> run(const std::vector<Variant>& variants, int jobs) {
    for (const Variant& variant : variants)
      if (runsOn(variant, log_.name, seed_)) pending_.push_back(&variant);
    results_.resize(pending_.size());
    std::vector<std::thread> workers;
    for (int j = 0; j < jobs; ++j) workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers) worker.join();
    if (failure_) std::rethrow_exception(failure_);
    return std::move(results_);
  }

 private:
  void work() {
    for (std::size_t i; (i = next_++) < pending_.size();) try {
        runCase(*pending_[i], results_[i]);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        failure_ = std::current_exception();
        next_ = pending_.size();
      }
  }

  /// Bounds are those of a segmentation, and take as long as all other scores.
  static EvaluationOptions optionsFor(const Variant& variant) {
    EvaluationOptions options;
    options.bounds = variant.kind != VariantKind::Ablation;
    return options;
  }

  void runCase(const Variant& variant, CaseResult& result) {
    const MethodRun run = variant.run(log_);
    MapErrors errors;
    result = {log_.name, variant.name, seed_, log_.scans.size(),
              scoreRun(log_, run, optionsFor(variant), &errors)};
    const std::lock_guard<std::mutex> lock(mutex_);
    const PreservationRejection& map = result.scores.map;
    std::fprintf(stderr, "%-12s seed %d  %-18s PR %6.2f  RR %6.2f  F1 %.3f  %6.1f ms\n",
                 log_.name.c_str(), static_cast<int>(seed_), variant.name.c_str(),
                 map.preservationRate(), map.rejectionRate(), map.f1(),
                 result.scores.medianMilliseconds);
    if (seed_ == 1) observer_.finished({log_, variant, run, errors});
  }

  const LabelledLog& log_;
  std::uint64_t seed_;
  const ScoreboardObserver& observer_;
  std::vector<const Variant*> pending_;
  std::vector<CaseResult> results_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<CaseResult> runScoreboard(const ScoreboardRequest& request,
                                      const std::vector<Variant>& variants,
                                      const ScoreboardObserver& observer) {
  constexpr const char* kNoScene = "none";
  for (const std::string& scene : request.scenes)
    if (scene != kNoScene) sceneByName(scene);
  std::vector<CaseResult> all;
  const auto runLog = [&](const LabelledLog& log, std::uint64_t seed) {
    if (seed == 1) observer.log(log);
    for (CaseResult& result : LogRunner(log, seed, observer).run(variants, request.jobs))
      all.push_back(std::move(result));
  };
  for (const SceneInfo& scene : knownScenes()) {
    const auto& wanted = request.scenes;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), scene.name) == wanted.end())
      continue;
    for (int seed = 1; seed <= request.seeds; ++seed)
      runLog(simulate(scene.name, static_cast<std::uint64_t>(seed), request.frames),
             static_cast<std::uint64_t>(seed));
  }
  if (request.realSequence.empty()) return all;
  ScanChoice choice;
  if (request.frames > 0) choice.to = static_cast<std::uint64_t>(request.frames) - 1;
  LabelledLog real = readLabelledLog(request.realSequence, choice, InputOptions());
  real.name = "real";
  runLog(real, 1);
  return all;
}

}  // namespace toss
