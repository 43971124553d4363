// SPDX-License-Identifier: BSD-3-Clause
#include "ResultSummary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace toss {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void add(const CaseResult& result, SceneScore& sum) {
  const RunScores& s = result.scores;
  if (sum.seeds++ == 0) sum.scans = result.scans;
  sum.preservation += s.map.preservationRate(), sum.rejection += s.map.rejectionRate();
  sum.f1 += s.map.f1();
  sum.iou += 100.0 * s.moving.all.intersectionOverUnion();
  sum.liveIou += s.liveMoving ? 100.0 * s.liveMoving->all.intersectionOverUnion() : kNone;
  sum.instanceBound += s.instanceBound ? s.instanceBound->rejectionRate() : kNone;
  sum.traceBound += s.traceBound ? s.traceBound->rejectionRate() : kNone;
  sum.median += s.medianMilliseconds, sum.percentile95 += s.percentile95Milliseconds;
}

void divide(SceneScore& sum) {
  const double n = sum.seeds;
  for (double* value : {&sum.preservation, &sum.rejection, &sum.f1, &sum.iou, &sum.liveIou,
                        &sum.instanceBound, &sum.traceBound, &sum.median, &sum.percentile95})
    *value /= n;
}

SceneScore firstSeed(const std::vector<CaseResult>& results, const std::string& scene,
                     const std::string& variant) {
  SceneScore score;
  for (const CaseResult& r : results)
    if (r.scene == scene && r.variant == variant && r.seed == 1) add(r, score);
  return score;
}

}  // namespace

SceneScore sceneScore(const std::vector<CaseResult>& results, const std::string& scene,
                      const std::string& variant) {
  SceneScore score;
  for (const CaseResult& r : results)
    if (r.scene == scene && r.variant == variant) add(r, score);
  if (score.seeds > 0) divide(score);
  return score;
}

const CaseResult* firstResult(const std::vector<CaseResult>& results, const std::string& scene,
                              const std::string& variant) {
  for (const CaseResult& r : results)
    if (r.scene == scene && r.variant == variant && r.seed == 1) return &r;
  return nullptr;
}

std::string numberText(double value, int decimals, bool sign) {
  if (!std::isfinite(value)) return "-";
  char text[48];
  std::snprintf(text, sizeof(text), sign ? "%+.*f" : "%.*f", decimals, value);
  return text;
}

std::vector<std::string> scenesWorstFirst(const std::vector<CaseResult>& results) {
  std::vector<std::string> scenes;
  for (const CaseResult& r : results)
    if (std::find(scenes.begin(), scenes.end(), r.scene) == scenes.end()) scenes.push_back(r.scene);
  std::stable_sort(scenes.begin(), scenes.end(), [&](const auto& a, const auto& b) {
    return sceneScore(results, a, kDefaultName).f1 < sceneScore(results, b, kDefaultName).f1;
  });
  return scenes;
}

Difference differenceToDefault(const std::vector<CaseResult>& results, const std::string& variant) {
  Difference mean;
  int scenes = 0;
  for (const std::string& scene : scenesWorstFirst(results)) {
    const SceneScore with = firstSeed(results, scene, kDefaultName);
    const SceneScore without = firstSeed(results, scene, variant);
    if (with.seeds == 0 || without.seeds == 0) continue;
    ++scenes;
    const double change = without.f1 - with.f1;
    mean.preservation += without.preservation - with.preservation;
    mean.rejection += without.rejection - with.rejection;
    mean.f1 += change, mean.iou += without.iou - with.iou;
    mean.milliseconds += without.median - with.median;
    if (mean.mostChanged.empty() || std::abs(change) > std::abs(mean.mostChange))
      mean.mostChanged = scene, mean.mostChange = change;
  }
  for (double* value :
       {&mean.preservation, &mean.rejection, &mean.f1, &mean.iou, &mean.milliseconds})
    *value /= std::max(scenes, 1);
  return mean;
}

}  // namespace toss
