// SPDX-License-Identifier: BSD-3-Clause
#include <toss/evaluation/ClearMot.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace toss {
namespace {

constexpr int kRecallSteps = 40;

/// A confidence at which the recall comes nearest to the wanted one.
struct RecallStep {
  double recall = 0.0, threshold = 0.0;
};

/// Walks down the matches by confidence and takes the match whose recall is nearest to each
/// multiple of 1 / kRecallSteps; the step of recall 0 is dropped.
std::vector<RecallStep> recallSteps(std::vector<double> confidences, std::uint64_t objects) {
  std::sort(confidences.begin(), confidences.end(), std::greater<>());
  std::vector<RecallStep> steps;
  const auto total = static_cast<double>(objects);
  double wanted = 0.0;
  for (std::size_t i = 0; i < confidences.size(); ++i) {
    const bool last = i + 1 == confidences.size();
    const double here = static_cast<double>(i + 1) / total;
    const double next = last ? here : static_cast<double>(i + 2) / total;
    if (!last && next - wanted < wanted - here) continue;
    steps.push_back({wanted, confidences[i]});
    wanted += 1.0 / kRecallSteps;
  }
  if (!steps.empty()) steps.erase(steps.begin());
  return steps;
}

double scaledAccuracy(const ClearMot& score, double recall) {
  const auto objects = static_cast<double>(score.objects);
  const auto errors =
      static_cast<double>(score.misses + score.falseAlarms + score.identitySwitches);
  return std::clamp(1.0 - (errors - (1.0 - recall) * objects) / (recall * objects), 0.0, 1.0);
}

}  // namespace

AveragedAccuracy averageAccuracy(const std::vector<TrackingScan>& scans,
                                 const TrackConfidence& confidence) {
  std::vector<double> matchConfidence;
  const ClearMot all = scoreTracks(scans, confidence, 0.0, &matchConfidence);
  if (all.objects == 0) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
  }
  AveragedAccuracy sum;
  for (const RecallStep& step : recallSteps(std::move(matchConfidence), all.objects)) {
    const ClearMot score = scoreTracks(scans, confidence, step.threshold);
    sum.amota += score.accuracy() / kRecallSteps;
    sum.samota += scaledAccuracy(score, step.recall) / kRecallSteps;
    sum.amotp += score.matches == 0 ? 0.0 : score.precision() / kRecallSteps;
  }
  return sum;
}

}  // namespace toss
