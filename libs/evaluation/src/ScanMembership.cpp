// SPDX-License-Identifier: BSD-3-Clause
#include "ScanMembership.h"

#include <toss/evaluation/MapEstimates.h>
#include <toss/rawlog/LabelFile.h>
#include <toss/segmentation/Segmentation.h>

#include <limits>

namespace toss {
namespace {

constexpr std::uint64_t kSmallObject = 10;

std::uint16_t bitIf(ScoredMap map, bool condition) {
  return condition ? MapEstimates::bit(map) : std::uint16_t{0};
}

template <typename... Bits>
std::uint16_t join(Bits... bits) {
  return static_cast<std::uint16_t>((0 | ... | bits));
}

}  // namespace

bool isKept(std::uint32_t runLabel) {
  return label::semantic(runLabel) != label::kInvalid && !label::isMoving(runLabel);
}

ScanMembership::ScanMembership(const EvaluationOptions& options, const LabelSurvey& survey)
    : options_(options), survey_(survey) {}

void ScanMembership::prepare(const ScanLabelSets& labels) {
  instances_.clear(), boxes_.clear(), objectReturns_.clear();
  if (!labels.instances.empty()) {
    instances_.add(labels.truth, labels.instances, survey_.ignoreUnlabelled);
  }
  if (!labels.run.empty()) boxes_.add(labels.truth, labels.run, survey_.ignoreUnlabelled);
  for (const std::uint32_t value : labels.truth) {
    if (label::isMoving(value) && label::instance(value) != 0) ++objectReturns_[value];
  }
}

std::uint64_t ScanMembership::objectReturns(std::uint32_t truth) const {
  const auto found = objectReturns_.find(truth);
  return found == objectReturns_.end() ? std::numeric_limits<std::uint64_t>::max() : found->second;
}

LossCause ScanMembership::causeWithoutInstance(std::uint32_t truth) const {
  return objectReturns(truth) < kSmallObject ? LossCause::NoInstanceSmall : LossCause::NoInstance;
}

LossCause ScanMembership::causeOf(const ScanLabelSets& labels, std::size_t i) const {
  const bool segmented = !labels.instances.empty();
  const std::uint32_t group = segmented             ? label::instance(labels.instances[i])
                              : !labels.run.empty() ? label::instance(labels.run[i])
                                                    : 0;
  if (segmented) {
    switch (static_cast<PointClass>(label::semantic(labels.instances[i]))) {
      case PointClass::Invalid:
      case PointClass::OutOfRange:
        return LossCause::Invalid;
      case PointClass::Ground:
      case PointClass::BelowGround:
        return LossCause::Ground;
      case PointClass::Unclustered:
        return causeWithoutInstance(labels.truth[i]);
      case PointClass::Instance:
        break;
    }
  } else if (labels.run.empty()) {
    return LossCause::Classification;
  }
  if (group == 0) return causeWithoutInstance(labels.truth[i]);
  const ClassOracle& oracle = segmented ? instances_ : boxes_;
  return oracle.moving(group) ? LossCause::Classification : LossCause::Merged;
}

std::uint16_t ScanMembership::oracleMembership(const ScanLabelSets& labels, std::size_t i) const {
  if (labels.run.empty() || label::semantic(labels.run[i]) == label::kInvalid) return 0;
  const std::uint32_t trace = label::instance(labels.run[i]);
  const bool segmented = !labels.instances.empty();
  const bool instanceMoves = segmented && instances_.moving(label::instance(labels.instances[i]));
  return join(bitIf(kInstanceOracleMap, segmented && !instanceMoves),
              bitIf(kBoxOracleMap, !boxes_.moving(trace)),
              bitIf(kTraceOracleMap, !survey_.traces.moving(trace)));
}

std::uint16_t ScanMembership::returnsMembership(std::uint32_t truth) const {
  const std::uint64_t returns = label::isMoving(truth) ? objectReturns(truth) : 0;
  return join(bitIf(kReturns10Map, returns < 10), bitIf(kReturns5Map, returns < 5),
              bitIf(kReturns3Map, returns < 3));
}

void ScanMembership::compute(const ScanGeometry& geometry, const ScanLabelSets& labels) {
  prepare(labels);
  membership_.assign(labels.truth.size(), 0);
  facts_.resize(labels.truth.size());
  const auto egoRadius = static_cast<float>(options_.egoRadius);
  for (std::size_t i = 0; i < labels.truth.size(); ++i) {
    const std::uint32_t truth = labels.truth[i];
    ReturnFacts facts;
    facts.band = rangeBand(geometry.range[i]);
    if (label::isMoving(truth)) {
      facts.returns = returnStep(objectReturns(truth));
      facts.cause = causeOf(labels, i);
    }
    facts_[i] = packFacts(truth, facts);
    const bool annotated = !survey_.ignoreUnlabelled || label::semantic(truth) != 0;
    if (geometry.horizontalRange[i] < egoRadius || !annotated) continue;
    membership_[i] =
        join(bitIf(kTruthMap, true), bitIf(kRunMap, !labels.run.empty() && isKept(labels.run[i])),
             bitIf(kLiveMap, !labels.live.empty() && isKept(labels.live[i])));
    if (!options_.bounds) continue;
    membership_[i] = join(membership_[i], oracleMembership(labels, i), returnsMembership(truth));
  }
}

}  // namespace toss
