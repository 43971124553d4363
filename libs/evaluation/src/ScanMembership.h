// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toss/evaluation/ClassOracle.h>
#include <toss/evaluation/EvaluationOptions.h>
#include <toss/evaluation/LossCauses.h>

#include <cstdint>
#include <map>
#include <vector>

#include "LabelSurvey.h"
#include "ScanGeometry.h"

namespace toss {

/// The maps that are made of the same scans, by their number in MapEstimates.
enum ScoredMap {
  kTruthMap,           ///< every annotated return outside the ego radius
  kRunMap,             ///< called static by the final labels
  kLiveMap,            ///< called static by the live labels
  kInstanceOracleMap,  ///< right class for every instance of the segmentation
  kBoxOracleMap,       ///< right class for every trace in every scan
  kTraceOracleMap,     ///< right class for every trace
  kReturns10Map,       ///< without moving objects of 10 or more returns in the scan; 5; 3
  kReturns5Map,
  kReturns3Map,
  kScoredMaps
};

/// Labels of one scan, shape [points] each; empty where there are none. `instances` is an optional
/// output of a run: low 16 bits PointClass, high 16 bits number of the instance in the scan.
struct ScanLabelSets {
  std::vector<std::uint32_t> truth, run, live, instances;
};

/// Whether the run keeps a return in its map: called neither moving nor invalid.
bool isKept(std::uint32_t runLabel);

/// Decides for each return of a scan which maps hold it, and why it might stay where it should not.
class ScanMembership {
 public:
  ScanMembership(const EvaluationOptions& options, const LabelSurvey& survey);

  void compute(const ScanGeometry& geometry, const ScanLabelSets& labels);

  /// Bits by ScoredMap, shape [points].
  const std::vector<std::uint16_t>& membership() const { return membership_; }
  /// True class with facts, see packFacts(), shape [points].
  const std::vector<std::uint32_t>& facts() const { return facts_; }

 private:
  void prepare(const ScanLabelSets& labels);
  std::uint64_t objectReturns(std::uint32_t truth) const;
  LossCause causeOf(const ScanLabelSets& labels, std::size_t i) const;
  LossCause causeWithoutInstance(std::uint32_t truth) const;
  std::uint16_t oracleMembership(const ScanLabelSets& labels, std::size_t i) const;
  std::uint16_t returnsMembership(std::uint32_t truth) const;

  const EvaluationOptions& options_;
  const LabelSurvey& survey_;
  ClassOracle instances_, boxes_;
  /// Returns in the scan by true label of moving objects that have an instance number.
  std::map<std::uint32_t, std::uint64_t> objectReturns_;
  std::vector<std::uint16_t> membership_;
  std::vector<std::uint32_t> facts_;
};

}  // namespace toss
